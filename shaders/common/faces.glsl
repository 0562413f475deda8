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

// Of the first face of a ray; `at`: in a picture ACROSS times as wide.
uint facePlace(ivec2 at) { return uint(KEPT) * (uint(at.y) * uint(ACROSS) * uint(frame.viewport.x) + uint(at.x)); }
