// SPDX-License-Identifier: Apache-2.0
// The floor plane y = 0 without being drawn: where a ray meets it, and of what it is made there.
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/fine_grain.glsl"

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

// A place on the floor and how much of the floor a pixel shows there.
struct FloorPlace {
    vec2 at;          // m
    vec2 width;       // m along x and z
    float footprint;  // m, the wider way
};

float floorNoise(FloorPlace place, float size, float seed) {
    return noiseOver(vec3(place.at / size, seed), place.footprint / size).w;
}

// Of a board or a tile, from its whole numbers: 0..1.
float ownValue(vec2 piece) {
    return fract(52.9829189 * fract(dot(piece, vec2(0.06711056, 0.00583715)) + 0.31));
}

#if FLOOR == FLOOR_CONCRETE
#include "common/floor_concrete.glsl"
#elif FLOOR == FLOOR_PLANKS
#include "common/floor_planks.glsl"
#elif FLOOR == FLOOR_GRID
#include "common/floor_grid.glsl"
#elif FLOOR == FLOOR_CHECKER
#include "common/floor_checker.glsl"
#else
void floorMaterial(FloorPlace place, inout Surface s) {
    s.albedo = frame.floor_colour.rgb;
    s.roughness = 0.9;
}
#endif

// `position` on the floor, where `ray` meets it.
Surface floorSurface(vec3 position, vec3 ray) {
    // How far one pixel to the right and one up lie on the floor, m.
    vec3 right = 2.0 * frame.viewport.z * frame.ray_right.xyz, up = 2.0 * frame.viewport.w * frame.ray_up.xyz;
    vec2 step_x = frame.eye.y * (ray.xz * right.y - right.xz * ray.y) / (ray.y * ray.y);
    vec2 step_y = frame.eye.y * (ray.xz * up.y - up.xz * ray.y) / (ray.y * ray.y);
    FloorPlace place;
    place.at = position.xz;
    place.width = abs(step_x) + abs(step_y);
    place.footprint = sqrt(max(dot(step_x, step_x), dot(step_y, step_y)));
    Surface s;
    s.position = position;
    s.geometric_normal = vec3(0.0, 1.0, 0.0);
    s.normal = s.geometric_normal;
    s.metalness = 0.0;
    floorMaterial(place, s);
    return s;
}
