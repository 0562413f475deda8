// The block of uniforms that all passes of a frame share (shaders/common/frame.glsl).
#pragma once
#include <glm/glm.hpp>

#include "engine/render/renderer.h"

namespace demolish::engine {

/// std140, the order and names of shaders/common/frame.glsl.
struct FrameUniforms {
    glm::mat4 view_projection, view, light_matrix;
    glm::vec4 eye, ray_right, ray_up, ray_forward;
    glm::vec4 to_sun, sun_colour, sky_zenith, sky_horizon, floor_colour;
    glm::vec4 viewport, shadow, depth_range, scene;
};
static_assert(sizeof(FrameUniforms) == 3 * 64 + 13 * 16);

/// `shadow_map_size` in texels.
FrameUniforms makeFrameUniforms(const FrameView& view, int shadow_map_size);

}  // namespace demolish::engine
