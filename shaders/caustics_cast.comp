// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Follows the sun's rays through transparent bodies to the floor: in where the first face is, out where the last is, bent as
// much as the way between them is filled. What falls on a texel of the sun's view is spread over where its corners arrive.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/glass_face_loss.glsl"
#include "common/caustics.glsl"
layout(binding = 3) uniform sampler2D glass_ends;     // common/glass_ends.glsl
layout(binding = 14) uniform sampler2D glass_shadow;  // m inside of bodies; -log of what their faces leave

// Where a ray meets the floor. Until then it is followed in m along u, v and depth.
struct Arrival {
    vec2 at;    // in texels of the caustics
    vec3 left;  // of its light
    int kind;
};
const int kClear = 0, kLost = 1, kArrives = 2;

const int kTile = 9;  // rays along a group: corners of its texels
shared Arrival arrivals[kTile * kTile];

vec3 metres() { return vec3(frame.shadow[0].zz, frame.shadow[0].w); }

// Depth, m, of the first (0) or the last face; below 0: there is none.
float depthOf(vec2 uv, int end) {
    vec2 ends = textureLod(glass_ends, uv, 0.0).rg;
    if (min(ends.r, ends.g) < 0.0) return -1.0;
    return metres().z * (end == 0 ? 1.0 - ends.r : ends.g);
}

// Rise in the middle of three depths; where one is missing, or the face ends between them, of the flatter two.
float riseOf(float a, float b, float c, float step_m) {
    float before = b - a, after = c - b;
    if (a < 0.0 && c < 0.0) return 0.0;
    if (a < 0.0) return after / step_m;
    if (c < 0.0) return before / step_m;
    if (abs(after - before) > 3.0 * step_m) return (abs(after) < abs(before) ? after : before) / step_m;
    return 0.5 * (before + after) / step_m;
}

// Over so many texels a face's slope is looked for: triangles are as wide.
const float kReach = 3.0;

vec2 slopeOf(vec2 uv, int end) {
    float reach = kReach / float(textureSize(glass_ends, 0).x), step_m = reach * metres().x;
    float z[9];
    for (int k = 0; k < 9; ++k) z[k] = depthOf(uv + reach * vec2(k % 3 - 1, k / 3 - 1), end);
    vec2 slope = vec2(0.0), weight = vec2(0.0);
    for (int k = 0; k < 3; ++k) {
        float w = k == 1 ? 2.0 : 1.0;
        if (z[3 * k + 1] >= 0.0) {
            slope.x += w * riseOf(z[3 * k], z[3 * k + 1], z[3 * k + 2], step_m);
            weight.x += w;
        }
        if (z[3 + k] >= 0.0) {
            slope.y += w * riseOf(z[k], z[3 + k], z[6 + k], step_m);
            weight.y += w;
        }
    }
    return slope / max(weight, vec2(1.0));
}

// From `exit` on: where it meets the floor.
bool meetsFloor(vec3 exit, vec3 way, out vec2 uv) {
    vec3 up = mat3(frame.light_matrix[0]) * vec3(0.0, 1.0, 0.0) * metres();
    vec3 floor_point = frame.light_matrix[0][3].xyz * metres();
    float down = -dot(way, up);
    uv = (exit + max(dot(exit - floor_point, up) / max(down, 1e-3), 0.0) * way).xy / metres().xy;
    return down > 0.02;
}

// From the first face on, which is at `front`, as the last is at `back`, m.
Arrival through(vec2 uv, float front, float back) {
    Arrival ray = Arrival(vec2(0.0), vec3(0.0), kLost);
    vec2 sums = max(textureLod(glass_shadow, uv, 1.0).rg, 0.0);
    float filled = clamp(sums.r / max(back - front, 1e-5 * metres().x), 0.0, 1.0), index = mix(1.0, frame.glass.w, filled);
    vec3 first = normalize(vec3(slopeOf(uv, 0), -1.0)), inside = refract(vec3(0.0, 0.0, 1.0), first, 1.0 / index);
    vec3 from = vec3(uv * metres().xy, front), exit = from;
    vec2 out_uv = uv;
    float way = max(back - front, 0.0) / inside.z;
    for (int k = 0; k < 4; ++k) {
        exit = from + way * inside;
        float last_depth = depthOf(exit.xy / metres().xy, 1);
        if (last_depth < 0.0) break;
        out_uv = exit.xy / metres().xy;
        way = mix(way, max(last_depth - front, 0.0) / inside.z, 0.8);
    }
    vec3 last = normalize(vec3(-slopeOf(out_uv, 1), 1.0)), outside = refract(inside, -last, index);
    if (dot(outside, outside) == 0.0 || !meetsFloor(exit, outside, ray.at)) return ray;
    ray.at *= float(kCausticTexels);
    float others = max(sums.g - lostAtFace(clamp(-first.z, 0.05, 1.0)) - lostAtFace(clamp(last.z, 0.05, 1.0)), 0.0);
    ray.left = exp(-frame.glass.rgb * way * filled - others) * leftByFace(-first.z) * leftByFace(max(dot(outside, last), 0.0));
    ray.kind = kArrives;
    return ray;
}

Arrival follow(vec2 uv) {
    Arrival ray = Arrival(vec2(0.0), vec3(0.0), kClear);
    float front = depthOf(uv, 0), back = depthOf(uv, 1);
    // A loop in place of a branch: software renderers go through branches that nobody takes, but not through loops.
    for (bool meets = front >= 0.0; meets; meets = false) ray = through(uv, front, back);
    return ray;
}

void addAt(ivec2 at, int texels, int first, ivec3 light) {
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(texels))) || light == ivec3(0)) return;
    int place = first + at.y * texels + at.x;
    atomicAdd(caustics[place].r, light.r);
    atomicAdd(caustics[place].g, light.g);
    atomicAdd(caustics[place].b, light.b);
}

// `at` in texels of the grid, whose middles lie at halves.
void splat(vec2 at, int texels, int first, vec3 light) {
    vec2 low = floor(at - 0.5), f = at - 0.5 - low;
    for (int k = 0; k < 4; ++k) {
        vec2 corner = vec2(k & 1, k >> 1), w = mix(1.0 - f, f, corner);
        addAt(ivec2(low + corner), texels, first, ivec3(round(light * w.x * w.y * kStepsOfLight)));
    }
}

void splatCoarse(vec2 at, vec3 light) {
    splat(at * float(kCoarseTexels) / float(kCausticTexels), kCoarseTexels, kCoarse, light);
}

const float kMostStretch = 4.0;  // texels, in the fine grid

// What one texel lets through, over the place where its corners arrive.
void spread(Arrival corner[4]) {
    vec2 a = corner[0].at, b = corner[1].at, c = corner[2].at, d = corner[3].at;
    float wide = max(length(b - a), length(d - c)), high = max(length(c - a), length(d - b));
    int across = max(int(ceil(wide - 0.01)), 1), along = max(int(ceil(high - 0.01)), 1);
    float share = 1.0 / float(across * along);
    for (int y = 0; y < along; ++y) {
        for (int x = 0; x < across; ++x) {
            vec2 f = (vec2(x, y) + 0.5) / vec2(across, along);
            vec3 left = mix(mix(corner[0].left, corner[1].left, f.x), mix(corner[2].left, corner[3].left, f.x), f.y);
            splat(mix(mix(a, b, f.x), mix(c, d, f.x), f.y), kCausticTexels, 0, share * left);
        }
    }
}

bool isWhole(Arrival corner[4]) {
    for (int k = 0; k < 4; ++k) {
        if (corner[k].kind != kArrives || distance(corner[k].at, corner[0].at) > kMostStretch) return false;
    }
    return true;
}

// A quarter of what a texel lets through, by one of its corners: towards the texel's middle.
void spreadCorner(Arrival corner, ivec2 texel, ivec2 offset) {
    if (corner.kind != kArrives) return;
    vec2 at = corner.at + 0.5 - vec2(offset);
    if (distance(corner.at, vec2(texel + offset)) > kMostStretch)
        splatCoarse(at, 0.25 * corner.left);
    else
        splat(at, kCausticTexels, 0, 0.25 * corner.left);
}

void main() {
    ivec2 tile = ivec2(gl_WorkGroupID.xy * gl_WorkGroupSize.xy), lane = ivec2(gl_LocalInvocationID.xy);
    for (uint k = gl_LocalInvocationIndex; k < uint(kTile * kTile); k += 64u) {
        arrivals[k] = follow(vec2(tile + ivec2(k % uint(kTile), k / uint(kTile))) / float(kCausticTexels));
    }
    barrier();
    Arrival corner[4];
    int met = 0;
    for (int k = 0; k < 4; ++k) {
        corner[k] = arrivals[(lane.y + (k >> 1)) * kTile + lane.x + (k & 1)];
        met += int(corner[k].kind != kClear);
    }
    if (met > 0) caustics[(tile.y + lane.y) * kCausticTexels + tile.x + lane.x].w = met;
    bool whole = isWhole(corner);
    for (bool all_arrive = whole; all_arrive; all_arrive = false) spread(corner);
    for (int k = whole || met == 0 ? 4 : 0; k < 4; ++k) spreadCorner(corner[k], tile + lane, ivec2(k & 1, k >> 1));
}
