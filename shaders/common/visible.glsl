// SPDX-License-Identifier: Apache-2.0
// What each sample of the picture shows, as passes find it that compute instead of drawing: depths (reversed, as bits, 0
// where there is nothing), then names (common/body_triangle.glsl), then cracks.
layout(std430, binding = 7) buffer Visible { uint visible[]; };

// Samples of the picture.
uint sampleTotal(int samples) { return uint(frame.viewport.x) * uint(frame.viewport.y) * uint(samples); }
uint sampleIndex(ivec2 pixel, int samples, int i) {
    return (uint(pixel.y) * uint(frame.viewport.x) + uint(pixel.x)) * uint(samples) + uint(i);
}

// Cracks: minus the logarithm of what they leave of the material, in steps, 16 bits a sample, added up by those that cross.
const float kCrackSteps = 64.0;  // for a factor of 2
uint crackWord(ivec2 pixel, int samples, int i) {
    return 2u * sampleTotal(samples) + 2u * (uint(pixel.y) * uint(frame.viewport.x) + uint(pixel.x)) + uint(i >> 1);
}
