// SPDX-License-Identifier: Apache-2.0
// What a face of a transparent body adds to the sums of the sun's light: the way inside, m (taken away where it goes in, added
// where it comes out), and minus the logarithm of what is left.
const float kBent = 0.9;  // what slanting faces bend out of its way

// `steep`: cosine between the sun and the face's normal.
float leftByFace(float steep) { return 1.0 - min(0.04 + 0.96 * pow(max(1.0 - steep, 0.0), 5.0), 0.95); }

float lostAtFace(float steep) { return kBent * pow(1.0 - steep, 1.5) - log(leftByFace(steep)); }

vec2 faceLoss(vec3 normal, vec3 world, float scattered) {
    float facing = dot(normal, frame.to_sun.xyz), steep = clamp(abs(facing), 0.05, 1.0);
    float along = -dot(world - frame.scene.xyz, frame.to_sun.xyz);
    return vec2(facing < 0.0 ? along : -along, lostAtFace(steep) + scattered);
}
