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
    glm::vec4 to_sun, sun_colour, floor_colour, floor_bounce, exposure;
    glm::vec4 harmonics[9];
    glm::vec4 viewport;
    glm::vec4 shadow[2];                   ///< of the near and the far region
    glm::vec4 to_far_scale, to_far_shift;  ///< u, v and depth of the far region from those of the near one
    glm::vec4 depth_range, scene, glass;
};
static_assert(sizeof(FrameUniforms) == 4 * 64 + 26 * 16);

/// What a view's light says of its surroundings, or what is usual.
const Surroundings& surroundingsOf(const Lighting& light);

/// `shadow_texels` along each side of a region of the shadow map.
FrameUniforms makeFrameUniforms(const FrameView& view, int shadow_texels);

}  // namespace demolish::engine
