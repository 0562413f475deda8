// SPDX-License-Identifier: Apache-2.0
// Triangles into the pictures of a frame: the camera's, and the regions of the shadow map. Of the triangles that have the nearest
// depth, the one drawn last gives its name: with WIDE_ATOMICS at once, otherwise in a second round, once depths are known. FACES: those of transparent bodies, both sides of them; SUMS: what these take from the sun's light, whose
// view stands in the place of the camera's.
#include "common/frame.glsl"
#include "common/body_triangle.glsl"
#include "common/coverage.glsl"
#include "common/put_shadow.glsl"

// Triangles that one lane has done and that may show: to be named.
layout(std430, binding = 8) buffer Found {
    uint found_count;
    uint large_count, task_count;
    uint pixel_count;  // of common/light_pixels.glsl
    uint found[];
};
// Triangles that are more than one lane's work, and the squares of kTaskEdge px that they touch: place in `large`; x in the
// low, y in the high half.
struct Large {
    Flat flat_on_view;
    uint name;
    int view, part;  // part: of two that the near plane makes
    float shift;     // of depth
};
layout(std430, binding = 9) buffer Tasks { uvec2 tasks[]; };
layout(std430, binding = 11) buffer LargeTriangles { Large large[]; };
const int kTaskEdge = 16;
#ifdef WIDE_ATOMICS
const bool kNamesLater = false;
#else
const bool kNamesLater = true;
#endif

layout(location = 0) uniform int naming;               // 0: depths, 1: names
layout(location = 1) uniform ivec2 sample_at[SAMPLES]; // inside the pixel, grid steps
layout(location = 6) uniform ivec4 sample_box;         // least and most of these
layout(location = 8) uniform vec2 shadow_offset;       // slopes, least steps of depth
layout(location = 9) uniform int lane_pixels;          // of a box that one lane goes through
layout(location = 10) uniform uint task_room;
layout(location = 11) uniform uint large_room;

const int kCamera = 0;  // views; 1 and 2 are the regions

#ifdef FACES
#include "common/shown_triangle.glsl"
#endif
#if defined(SUMS)
#include "common/put_sums.glsl"
#elif defined(FACES)
#include "common/put_face.glsl"
#else
#include "common/put_visible.glsl"
#endif

Flat cameraFlat(vec4 a, vec4 b, vec4 c) {
    vec2 size = cameraSize();
    return flatten((a.xy / a.w * 0.5 + 0.5) * size, (b.xy / b.w * 0.5 + 0.5) * size, (c.xy / c.w * 0.5 + 0.5) * size,
                   vec3(a.z / a.w, b.z / b.w, c.z / c.w), sample_box.xy, sample_box.zw, ivec2(size));
}

Flat shadowFlat(vec3 p[3], int region) {
    mat4 to_map = frame.light_matrix[region];
    vec3 a = (to_map * vec4(p[0], 1.0)).xyz, b = (to_map * vec4(p[1], 1.0)).xyz, c = (to_map * vec4(p[2], 1.0)).xyz;
    float texels = float(shadow_texels);
    return flatten(a.xy * texels, b.xy * texels, c.xy * texels, vec3(a.z, b.z, c.z), ivec2(kGrid / 2), ivec2(kGrid / 2),
                   ivec2(shadow_texels));
}

bool hasRoom() { return task_count <= task_room && large_count <= large_room; }

bool isLanesWork(Flat f) {
    ivec2 box = boxOf(f);
    return box.x * box.y <= lane_pixels && isNear(f);
}

// As glPolygonOffset: away from the sun by the slope, and by steps of single precision.
float shadowShift(Flat f) {
    int exponent = int((floatBitsToUint(abs(f.most)) >> 23) & 0xffu);
    float least_step = exponent > 23 ? uintBitsToFloat(uint(exponent - 23) << 23) : 0.0;
    return shadow_offset.x * float(kGrid) * max(abs(f.slope.x), abs(f.slope.y)) + shadow_offset.y * least_step;
}
