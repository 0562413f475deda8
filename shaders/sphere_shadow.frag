// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Depth of the sphere's sunward side.
in vec2 on_disc;
flat in float depth_radius;
flat in float centre_depth;

void main() {
    float inside = 1.0 - dot(on_disc, on_disc);
    if (inside < 0.0) discard;
    // Half way to the middle: casts the same shadow, and the lit side keeps clear of it.
    gl_FragDepth = centre_depth - 0.6 * depth_radius * sqrt(inside);
}
