// SPDX-License-Identifier: Apache-2.0
// Faces of transparent bodies as the sun sees them, in the near region of its map: they add up.
#include "common/gbuffer.glsl"
#include "common/glass_sums.glsl"
#include "common/glass_face_loss.glsl"
#include "common/glass_ends.glsl"
layout(location = 12) uniform float scattered;  // by a broken face, -log of what is left

vec2 cameraSize() { return vec2(kSumTexels); }

// Nothing is nearer to the sun than what is cut away.
vec4 clipOf(vec3 p) { return vec4(2.0 * (frame.light_matrix[0] * vec4(p, 1.0)).xy - 1.0, 0.5, 1.0); }

float across(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Where in the triangle the middle of a texel lies, but never off it.
vec3 weightsIn(vec3 p[3], ivec2 at) {
    vec2 a = (frame.light_matrix[0] * vec4(p[0], 1.0)).xy, b = (frame.light_matrix[0] * vec4(p[1], 1.0)).xy - a;
    vec2 c = (frame.light_matrix[0] * vec4(p[2], 1.0)).xy - a, to = (vec2(at) + 0.5) / float(kSumTexels) - a;
    float area = across(b, c);
    vec2 w = vec2(across(to, c), across(b, to)) / (abs(area) > 1e-30 ? area : 1e-30);
    vec3 weights = max(vec3(1.0 - w.x - w.y, w), 0.0);
    return weights / (weights.x + weights.y + weights.z);
}

bool putCamera(Flat f, ivec2 at, uint covered, uint name) {
    BodyVertex v[3];
    fetchTriangle(name, v);
    FragmentTransform t = motionOf(v[0]);  // all corners are of one fragment
    vec3 p[3], normal = vec3(0.0), world = vec3(0.0);
    for (int k = 0; k < 3; ++k) p[k] = moved(t, v[k].rest);
    vec3 weights = weightsIn(p, at);
    for (int k = 0; k < 3; ++k) {
        world += weights[k] * p[k];
        normal += weights[k] * decodeOctahedral(unpackSnorm2x16(v[k].normal));
    }
    vec2 loss = faceLoss(normalize(rotate(t.rotation, normal)), world, isInterior(name) ? scattered : 0.0);
    ivec2 steps = ivec2(round(loss * vec2(kStepsOfRadius / frame.scene.w, kStepsOfLost)));
    ivec2 ends = 1 + ivec2(round(endsAt(world) * kStepsOfEnds));
    uint place = uint(at.y * kSumTexels + at.x);
    atomicAdd(sums[place].x, steps.x);
    atomicAdd(sums[place].y, steps.y);
    // Most faces are not at an end; what is read may be old, and is then too small.
    if (sums[place].z < ends.x) atomicMax(sums[place].z, ends.x);
    if (sums[place].w < ends.y) atomicMax(sums[place].w, ends.y);
    return false;
}
