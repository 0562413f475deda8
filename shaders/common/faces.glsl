// SPDX-License-Identifier: Apache-2.0
// Faces of transparent bodies along each ray, as a computing pass finds them: KEPT depths a ray (reversed, as bits, the nearest
// first, 0 where there is none), then their names (common/body_triangle.glsl).
layout(std430, binding = 7) buffer Faces { uint faces[]; };

// Of the first face of a ray; `at`: in a picture ACROSS times as wide.
uint facePlace(ivec2 at) { return uint(KEPT) * (uint(at.y) * uint(ACROSS) * uint(frame.viewport.x) + uint(at.x)); }
uint faceNames() { return uint(KEPT * ACROSS * ACROSS) * uint(frame.viewport.x) * uint(frame.viewport.y); }
