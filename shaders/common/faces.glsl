// SPDX-License-Identifier: Apache-2.0
// Faces of transparent bodies along each ray, as a computing pass finds them: KEPT of a ray, the nearest first. x: name
// (common/body_triangle.glsl), y: depth (reversed, as bits, 0 where there is none).
#ifdef WIDE_ATOMICS
layout(std430, binding = 7) buffer Faces { uint64_t wide_faces[]; };  // y in the high half
uvec2 faceAt(uint place) { return unpackUint2x32(wide_faces[place]); }
#else
layout(std430, binding = 7) buffer Faces { uvec2 faces[]; };
uvec2 faceAt(uint place) { return faces[place]; }
#endif

// Of the `k`-th face of the ray `at`, in a picture ACROSS times as wide. First faces lie together, as most rays have none, and
// so do the rays of a pixel.
uint facePlace(ivec2 at, uint k) {
    uvec2 pixel = uvec2(at / ACROSS), ray = uvec2(at % ACROSS), pixels = uvec2(frame.viewport.xy);
    return uint(ACROSS * ACROSS) * (pixels.x * (pixels.y * k + pixel.y) + pixel.x) + uint(ACROSS) * ray.y + ray.x;
}
