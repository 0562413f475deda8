// SPDX-License-Identifier: Apache-2.0
// The block of uniforms that all passes of a frame share (shaders/common/frame.glsl).
#pragma once
#include <glm/glm.hpp>

#include "engine/scene/frame_view.h"

namespace demolish::engine {

/// std140, the order and names of shaders/common/frame.glsl.
struct FrameUniforms {
    glm::mat4 view_projection, view;
    glm::mat4 light_matrix[2];  ///< of the near and the far region
    glm::vec4 eye, ray_right, ray_up, ray_forward;
    glm::vec4 to_sun, sun_colour, sky_zenith, sky_horizon, floor_colour;
    glm::vec4 viewport;
    glm::vec4 shadow[2];                   ///< of the near and the far region
    glm::vec4 to_far_scale, to_far_shift;  ///< u, v and depth of the far region from those of the near one
    glm::vec4 depth_range, scene;
};
static_assert(sizeof(FrameUniforms) == 4 * 64 + 16 * 16);

/// `shadow_texels` along each side of a region of the shadow map.
FrameUniforms makeFrameUniforms(const FrameView& view, int shadow_texels);

}  // namespace demolish::engine
