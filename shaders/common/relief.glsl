// SPDX-License-Identifier: Apache-2.0
// How far the material's relief moves a place of a broken face: a function of the rest position alone, so that both sides of a
// break fit, no seam opens between triangles, and nothing swims. Where its waves are small on the picture it is gone.
#include "common/frame.glsl"
#include "common/noise.glsl"
#include "common/body.glsl"
#define CELL_LOOKS 10
#include "common/cell_look.glsl"

// Of each look (common/cell_look.glsl): x height, y length of its longest waves, m; a height of 0: none.
layout(location = 40) uniform vec2 relief_of_look[32];
layout(location = 35) uniform uint look_count;
const float kWavesFrom = 14.0, kWavesWhole = 26.0;  // px of the longest waves: from here on, and in full

// Where there is one look, cells may have none said.
vec2 reliefOf(uint cell) { return relief_of_look[look_count > 1u ? min(cell_look[cell] & 0xffffu, look_count - 1u) : 0u]; }

// Pixels that a metre across the view takes at a place.
float pixelsPerMetre(vec3 world) { return 0.5 * frame.viewport.y / (frame.depth_range.z * max(distance(world, frame.eye.xyz), 1e-6)); }

// Three noises, so that it also moves along a face and edges lose their straightness. `p` in lattice cells.
vec3 threeNoises(vec3 p) {
    return vec3(noiseOver(p, 0.0).w, noiseOver(p.yzx + vec3(2.7, 5.1, 1.3), 0.0).w, noiseOver(p.zxy + vec3(6.2, 0.4, 3.9), 0.0).w);
}

// Of a height of 1. `per_metre`: 1 over the longest waves. Shorter ones are lower: faces must not fold.
vec3 reliefShape(vec3 rest, float per_metre) {
    vec3 p = per_metre * rest;
    return threeNoises(p) + 0.5 * threeNoises(2.03 * (kTurn1 * p)) + 0.25 * threeNoises(4.11 * (kTurn2 * p)) +
           0.12 * threeNoises(8.3 * (kTurn1 * (kTurn2 * p)));
}

// Share of the relief at a place; `depth`: 0 at the outside, which stays, .. 1 deep.
float reliefShare(vec3 world, float depth, vec2 relief) {
    return smoothstep(kWavesFrom, kWavesWhole, relief.y * pixelsPerMetre(world)) * smoothstep(0.0, 0.34, depth);
}
