// SPDX-License-Identifier: Apache-2.0
// The floor plane y = 0 without being drawn: where a ray meets it, and its large tiles in two tones with thin joints.
#include "common/gbuffer.glsl"
#include "common/noise.glsl"

const float kNoFloor = 1e30;

// Distance along the view axis at which a ray (forward + x * right + y * up) meets the floor; kNoFloor: it does not. Seen
// from below there is no floor, so that a camera under it still sees the body.
float floorAlong(vec3 ray) {
    if (frame.floor_colour.w == 0.0 || frame.eye.y <= 0.0 || ray.y >= 0.0) return kNoFloor;
    float along = frame.eye.y / -ray.y;
    float beside = along * max(abs(ray.x), abs(ray.z));
    return along < frame.depth_range.y && beside < kFloorReach * frame.depth_range.y ? along : kNoFloor;
}

// Mean of a square wave (+1, -1, period 2) over a pixel of width w: edges stay smooth, far tiles melt to the mean.
float filteredWave(float x, float w) {
    vec2 ends = vec2(x - 0.5 * w, x + 0.5 * w);
    vec2 integral = abs(fract(ends * 0.5) * 2.0 - 1.0);
    return clamp((integral.x - integral.y) / w, -1.0, 1.0);
}

// Coverage of a joint of half width h at whole numbers, seen through a pixel of width w.
float joint(float x, float h, float w) {
    float distance = abs(fract(x + 0.5) - 0.5);
    float blur = max(w, 1e-4);
    return clamp((h + 0.5 * blur - distance) / blur, 0.0, 1.0) * min(1.0, 2.0 * h / blur);
}

// `position` on the floor, where `ray` meets it.
Surface floorSurface(vec3 position, vec3 ray) {
    float tile_size = frame.eye.w;
    vec2 tile = position.xz / tile_size;
    // How far one pixel to the right and one up lie on the floor, m.
    vec3 right = 2.0 * frame.viewport.z * frame.ray_right.xyz, up = 2.0 * frame.viewport.w * frame.ray_up.xyz;
    vec2 step_x = frame.eye.y * (ray.xz * right.y - right.xz * ray.y) / (ray.y * ray.y);
    vec2 step_y = frame.eye.y * (ray.xz * up.y - up.xz * ray.y) / (ray.y * ray.y);
    vec2 width = max((abs(step_x) + abs(step_y)) / tile_size, vec2(1e-4));
    float footprint = sqrt(max(dot(step_x, step_x), dot(step_y, step_y)));
    float checker = filteredWave(tile.x, width.x) * filteredWave(tile.y, width.y);
    float line = max(joint(tile.x, 0.006, width.x), joint(tile.y, 0.006, width.y));
    float cloud_size = 0.7 * tile_size, grain_size = 0.045 * tile_size;
    float cloud = noiseOver(vec3(position.xz / cloud_size, 0.3), footprint / cloud_size).w;
#ifdef SHADOW_DRAFT
    float grain = 0.0;  // software renderers pay for the floor in every pixel
#else
    float grain = noiseOver(vec3(position.xz / grain_size, 1.7), footprint / grain_size).w;
#endif

    Surface s;
    s.position = position;
    s.geometric_normal = vec3(0.0, 1.0, 0.0);
    s.normal = s.geometric_normal;
    s.albedo = frame.floor_colour.rgb * (1.0 + 0.055 * checker + 0.02 * cloud + 0.02 * grain) * (1.0 - 0.28 * line);
    s.roughness = clamp(0.62 + 0.1 * cloud, 0.05, 1.0);
    s.metalness = 0.0;
    return s;
}
