// From what the caller wants to see to the numbers that shaders use.
#include "engine/render/frame_uniforms.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace demolish::engine {
namespace {

// Apparent radius of the light, tangent; larger than the real sun's 0.0047, which would look hard on a
// metre-sized body.
constexpr float kSunTangent = 0.035f;

constexpr float kTilesPerSceneRadius = 2.0f;

/// Tiles of a round size (1, 2 or 5 times a power of ten), about half the scene's radius.
float tileSize(float scene_radius) {
    const float wanted = std::max(scene_radius, 1e-4f) / kTilesPerSceneRadius;
    const float power = std::pow(10.0f, std::floor(std::log10(wanted)));
    const float digit = wanted / power;
    return power * (digit < 1.5f ? 1.0f : digit < 3.5f ? 2.0f : digit < 7.5f ? 5.0f : 10.0f);
}

/// World to shadow map: u, v in 0..1 over the scene's sphere, depth in 0..1 along the light.
glm::mat4 lightMatrix(glm::vec3 centre, float radius, glm::vec3 to_sun) {
    const glm::vec3 up = std::abs(to_sun.y) > 0.98f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::mat4 look = glm::lookAt(centre + to_sun * radius, centre, up);
    const float scale = 0.5f / radius;
    glm::mat4 map(1.0f);
    map[0][0] = scale;
    map[1][1] = scale;
    map[2][2] = -scale;  // lookAt looks along -z
    map[3] = glm::vec4(0.5f, 0.5f, 0.0f, 1.0f);
    return map * look;
}

}  // namespace

FrameUniforms makeFrameUniforms(const FrameView& view, int shadow_map_size) {
    const Camera& camera = view.camera;
    const Lighting& light = view.lighting;
    const float aspect = static_cast<float>(view.width) / static_cast<float>(view.height);
    const glm::vec3 centre(view.scene_centre[0], view.scene_centre[1], view.scene_centre[2]);
    const glm::vec3 to_sun = -glm::normalize(light.sun_direction);
    const float slope = std::tan(0.5f * camera.fov_y);

    FrameUniforms frame;
    frame.view = camera.view();
    frame.view_projection = camera.projection(aspect) * frame.view;
    frame.light_matrix = lightMatrix(centre, view.scene_radius, to_sun);
    const glm::mat4 axes = glm::transpose(frame.view);
    frame.eye = glm::vec4(camera.eye, tileSize(view.scene_radius));
    frame.ray_right = glm::vec4(glm::vec3(axes[0]) * slope * aspect, 0);
    frame.ray_up = glm::vec4(glm::vec3(axes[1]) * slope, 0);
    frame.ray_forward = glm::vec4(-glm::vec3(axes[2]), 0);
    frame.to_sun = glm::vec4(to_sun, kSunTangent);
    frame.sun_colour = glm::vec4(light.sun_colour, light.exposure);
    frame.sky_zenith = glm::vec4(light.sky_zenith, 0);
    frame.sky_horizon = glm::vec4(light.sky_horizon, 0);
    frame.floor_colour = glm::vec4(light.floor_colour, view.show_floor ? 1.0f : 0.0f);
    const auto width = static_cast<float>(view.width), height = static_cast<float>(view.height);
    const float extent = 2.0f * view.scene_radius;
    const auto texels = static_cast<float>(shadow_map_size);
    frame.viewport = {width, height, 1.0f / width, 1.0f / height};
    frame.shadow = {extent / texels, 1.0f / texels, extent, extent};
    frame.depth_range = {camera.near_plane, camera.far_plane, slope, aspect};
    frame.scene = glm::vec4(centre, view.scene_radius);
    return frame;
}

}  // namespace demolish::engine
