// SPDX-License-Identifier: Apache-2.0
// From what the caller wants to see to the numbers that shaders use.
#include "engine/render/frame_uniforms.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/shown.h"
#include "engine/surroundings/own_surroundings.h"

namespace demolish::engine {
namespace {

constexpr float kTilesPerSceneRadius = 2.0f;

/// Tiles of a round size (1, 2 or 5 times a power of ten), about half the scene's radius.
float tileSize(float scene_radius) {
    const float wanted = std::max(scene_radius, 1e-4f) / kTilesPerSceneRadius;
    const float power = std::pow(10.0f, std::floor(std::log10(wanted)));
    const float digit = wanted / power;
    return power * (digit < 1.5f ? 1.0f : digit < 3.5f ? 2.0f : digit < 7.5f ? 5.0f : 10.0f);
}

/// A square of the shadow map, with the sun above it.
struct ShadowRegion {
    glm::vec3 centre;
    float radius;  // m, half the width
    float depth;   // m, range along the light, centred
};

/// From a point of the lens, with the picture moved under its pixels by `shift` (of -1..1).
struct TakenFrom {
    glm::vec3 eye;
    glm::vec2 shift;
    glm::mat4 view, projection;
};

TakenFrom takenFrom(const FrameView& view, const glm::mat4& from_middle, float slope, float aspect) {
    const glm::vec2 offset = view.lens_offset;
    const glm::vec2 pixel = 2.0f / glm::vec2(view.width, view.height);
    TakenFrom taken;
    const glm::mat3 axes(glm::transpose(from_middle));
    taken.eye = view.camera.eye + offset.x * axes[0] + offset.y * axes[1];
    taken.view = glm::translate(glm::mat4(1), glm::vec3(-offset, 0)) * from_middle;
    // What lies at the focus comes back to where the middle of the lens sees it.
    taken.shift = offset / (view.focus_distance * glm::vec2(slope * aspect, slope)) + view.jitter * pixel;
    const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3(taken.shift, 0));  // times clip.w
    taken.projection = moved * view.camera.projection(aspect);
    return taken;
}

/// Unit; a light without a way to travel falls from the zenith.
glm::vec3 towardsSun(const Lighting& light) {
    const float length = glm::length(light.sun_direction);
    return length > 1e-12f ? -light.sun_direction / length : glm::vec3(0, 1, 0);
}

/// Across the light, and towards the sun.
glm::mat3 sunAxes(glm::vec3 to_sun) {
    const glm::vec3 up = std::abs(to_sun.y) > 0.98f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 right = glm::normalize(glm::cross(up, to_sun));
    return {right, glm::cross(to_sun, right), to_sun};
}

/// Round what the camera looks at, wide enough for what lies about there. It grows by doubling and moves by
/// whole texels, or the edges of shadows would crawl while the camera moves.
ShadowRegion farRegion(const FrameView& view, const glm::mat3& axes, int texels) {
    constexpr float kLeastScenes = 4, kCameraDistances = 3;
    const float scene = std::max(view.scene_radius, 1e-4f);
    const float distance = glm::length(view.camera.target - view.camera.eye);
    const float wanted = std::max(kLeastScenes, kCameraDistances * distance / scene);
    const float radius = scene * std::exp2(std::ceil(std::log2(wanted)));
    const float texel = 2 * radius / static_cast<float>(texels);
    const glm::vec3 whole = glm::round(glm::transpose(axes) * view.camera.target / texel) * texel;
    // Twice as deep as wide: the floor leaves a low sun's cube early.
    return {axes * whole, radius, 4 * radius};
}

/// World to region: u, v in 0..1, depth in 0..1 along the light.
glm::mat4 lightMatrix(const ShadowRegion& region, const glm::mat3& axes) {
    const glm::vec3 scale(0.5f / region.radius, 0.5f / region.radius, -1 / region.depth);
    const glm::mat3 turn = glm::mat3(glm::scale(glm::mat4(1), scale)) * glm::transpose(axes);
    glm::mat4 map(turn);
    map[3] = glm::vec4(glm::vec3(0.5f) - turn * region.centre, 1);
    return map;
}

glm::vec4 shadowSizes(const ShadowRegion& region, int texels) {
    const auto count = static_cast<float>(texels);
    return {2 * region.radius / count, 1 / count, 2 * region.radius, region.depth};
}

/// Share of its light that a floor mirrors, mean of all ways: environmentShare() of shaders/common/brdf.glsl
/// at a roughness of 0.62, weighed by the cosine. A dark floor sends up a quarter of its light so.
constexpr float kFloorMirrors = 0.043f;

/// Light of the sunlit floor seen from below, the same in all directions. Occlusion takes off what stands
/// before it and what stands on it shades.
glm::vec3 floorBounce(const Lighting& light, glm::vec3 to_sun) {
    const glm::vec3 sky = evaluate(surroundingsOf(light).above, {0, 1, 0});
    const glm::vec3 share = kFloorMirrors + (1 - kFloorMirrors) * light.floor_colour;
    return share * (light.sun_colour * std::max(to_sun.y, 0.0f) + sky);
}

void putLight(const FrameView& view, glm::vec3 to_sun, FrameUniforms& frame) {
    const Lighting& light = view.lighting;
    const Surroundings& around = surroundingsOf(light);
    const bool has_floor = view.hasFloor();
    frame.to_sun = glm::vec4(to_sun, light.sun_tangent);
    frame.sun_colour = glm::vec4(light.sun_colour, 0);
    frame.floor_colour = glm::vec4(light.floor_colour, has_floor ? 1.0f : 0.0f);
    frame.floor_bounce = glm::vec4(has_floor ? floorBounce(light, to_sun) : glm::vec3(0), 0);
    frame.exposure = glm::vec4(light.exposure * whiteBalance(light.temperature), view.noise_turn);
    for (size_t k = 0; k < around.above.size(); ++k)
        frame.harmonics[k] = glm::vec4(around.above[k] + (has_floor ? glm::vec3(0) : around.below[k]), 0);
}

}  // namespace

const Surroundings& surroundingsOf(const Lighting& light) {
    return light.surroundings ? *light.surroundings : *usualSurroundings();
}

FrameUniforms makeFrameUniforms(const FrameView& view, int shadow_texels) {
    const Camera& camera = view.camera;
    const Lighting& light = view.lighting;
    const float aspect = static_cast<float>(view.width) / static_cast<float>(view.height);
    const glm::vec3 centre(view.scene_centre[0], view.scene_centre[1], view.scene_centre[2]);
    const glm::vec3 to_sun = towardsSun(light);
    const float slope = camera.halfHeight(aspect);

    FrameUniforms frame;
    const TakenFrom taken = takenFrom(view, camera.view(), slope, aspect);
    frame.view = taken.view;
    frame.view_projection = taken.projection * frame.view;
    const glm::mat3 sun_axes = sunAxes(to_sun);
    const float near_radius = std::max(view.scene_radius, 1e-4f);
    const ShadowRegion regions[] = {{centre, near_radius, 2 * near_radius},
                                    farRegion(view, sun_axes, shadow_texels)};
    // The regions share their axes.
    frame.to_far_scale =
        glm::vec4(regions[0].radius / regions[1].radius, regions[0].radius / regions[1].radius,
                  regions[0].depth / regions[1].depth, 0);
    for (int i = 0; i < 2; ++i) {
        frame.light_matrix[i] = lightMatrix(regions[i], sun_axes);
        frame.shadow[i] = shadowSizes(regions[i], shadow_texels);
    }
    frame.to_far_shift = frame.light_matrix[1][3] - frame.to_far_scale * frame.light_matrix[0][3];
    const glm::mat4 axes = glm::transpose(frame.view);
    frame.eye = glm::vec4(taken.eye, tileSize(view.scene_radius));
    frame.ray_right = glm::vec4(glm::vec3(axes[0]) * slope * aspect, 0);
    frame.ray_up = glm::vec4(glm::vec3(axes[1]) * slope, 0);
    frame.ray_forward =
        glm::vec4(-glm::vec3(axes[2]), 0) - taken.shift.x * frame.ray_right - taken.shift.y * frame.ray_up;
    putLight(view, to_sun, frame);
    const auto width = static_cast<float>(view.width), height = static_cast<float>(view.height);
    frame.viewport = {width, height, 1.0f / width, 1.0f / height};
    frame.depth_range = {camera.near_plane, camera.far_plane, slope, aspect};
    frame.scene = glm::vec4(centre, view.scene_radius);
    const SurfaceLook glass = glassOf(view);
    frame.glass = {glass.absorption[0], glass.absorption[1], glass.absorption[2], glass.refraction_index};
    return frame;
}

}  // namespace demolish::engine
