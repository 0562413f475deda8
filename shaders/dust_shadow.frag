// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Adds up what dust lies on the sun's way, and where.
flat in vec2 depth;  // optical, and in the region
layout(location = 0) out vec2 sums;

void main() {
    vec2 corner = 2.0 * gl_PointCoord - 1.0;
    float inside = max(1.0 - dot(corner, corner), 0.0);
    sums = depth.x * inside * sqrt(inside) * vec2(1.0, depth.y);
}
