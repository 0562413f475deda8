// Triangles into the pictures of a frame: the camera's, and the regions of the shadow map. Depths first, the nearest wins;
// then, of the triangles that have this depth, the one drawn last gives its name.
#include "common/frame.glsl"
#include "common/body_triangle.glsl"
#include "common/coverage.glsl"
#include "common/visible.glsl"
layout(binding = 0, r32ui) uniform coherent uimage2D shadow_map;  // depths as bits, two regions side by side

// Triangles that cover samples, but for those in tasks: to be named.
layout(std430, binding = 8) buffer Found {
    uint found_count;
    uint task_count;
    uint found[];
};
// Triangles that are more than one lane's work, in squares of kTaskEdge px: name; view, y and x of the square.
layout(std430, binding = 9) buffer Tasks { uvec2 tasks[]; };
const int kTaskEdge = 64;

layout(location = 0) uniform int naming;            // 0: depths, 1: names
layout(location = 1) uniform int sample_count;
layout(location = 2) uniform ivec2 sample_at[4];    // inside the pixel, grid steps
layout(location = 6) uniform ivec4 sample_box;      // least and most of these
layout(location = 7) uniform int shadow_texels;     // along a region; 0: the map is not drawn
layout(location = 8) uniform vec2 shadow_offset;    // slopes, least steps of depth

const int kCamera = 0;  // views; 1 and 2 are the regions

// World to window; `w` along the view axis. True: the near plane cuts the triangle.
Flat cameraFlat(vec4 clip[3]) {
    vec2 window[3];
    vec3 depth;
    for (int k = 0; k < 3; ++k) {
        window[k] = (clip[k].xy / clip[k].w * 0.5 + 0.5) * frame.viewport.xy;
        depth[k] = clip[k].z / clip[k].w;
    }
    return flatten(window, depth, sample_box.xy, sample_box.zw, ivec2(frame.viewport.xy));
}

Flat shadowFlat(vec3 p[3], int region) {
    vec2 window[3];
    vec3 depth;
    for (int k = 0; k < 3; ++k) {
        vec3 at = (frame.light_matrix[region] * vec4(p[k], 1.0)).xyz;
        window[k] = at.xy * float(shadow_texels);
        depth[k] = at.z;
    }
    return flatten(window, depth, ivec2(kGrid / 2), ivec2(kGrid / 2), ivec2(shadow_texels));
}

// As glPolygonOffset: away from the sun by the slope, and by steps of single precision.
float shadowShift(Flat f, vec2 slope) {
    float most = max(f.depth[0], max(f.depth[1], f.depth[2]));
    int exponent = int((floatBitsToUint(abs(most)) >> 23) & 0xffu);
    float least_step = exponent > 23 ? uintBitsToFloat(uint(exponent - 23) << 23) : 0.0;
    return shadow_offset.x * float(kGrid) * max(abs(slope.x), abs(slope.y)) + shadow_offset.y * least_step;
}

// A covered sample. Does it show the triangle, as far as one knows by now?
bool putCamera(ivec2 pixel, int i, float depth, uint name) {
    if (depth <= 0.0 || depth > 1.0) return false;
    uint place = sampleIndex(pixel, sample_count, i), bits = floatBitsToUint(depth), held = visible[place];
    if (naming != 0) {
        if (held == bits) atomicMax(visible[sampleTotal(sample_count) + place], name);
        return true;
    }
    if (bits > held) atomicMax(visible[place], bits);
    return bits >= held;
}

void putShadow(ivec2 pixel, int region, float depth) {
    ivec2 at = pixel + ivec2(region * shadow_texels, 0);
    uint bits = depth > 0.0 ? floatBitsToUint(min(depth, 1.0)) : 0u;
    if (bits < imageLoad(shadow_map, at).r) imageAtomicMin(shadow_map, at, bits);
}
