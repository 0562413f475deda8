// SPDX-License-Identifier: Apache-2.0
// The ends of a ray of the sun in transparent bodies: 1 minus depth of the first face, and depth of the last, in the near region
// of the sun's map. The greater ones are kept.
const float kNoEnd = -1000.0;  // so far below that what is filtered with it is below 0

vec2 endsAt(vec3 world) {
    float depth = clamp((frame.light_matrix[0] * vec4(world, 1.0)).z, 0.0, 1.0);
    return vec2(1.0 - depth, depth);
}
