// SPDX-License-Identifier: Apache-2.0
// What each sample of the picture shows, as passes find it that compute instead of drawing: its name (common/body_triangle.glsl)
// and depth (reversed, as bits, 0 where there is nothing), sample by sample; then cracks. Programs with WIDE_ATOMICS know no cracks.
#ifdef WIDE_ATOMICS
layout(std430, binding = 7) buffer Visible { uint64_t visible[]; };  // depth in the high half
#else
layout(std430, binding = 7) buffer Visible { uint visible[]; };
#endif

// Samples of the picture.
uint sampleTotal(int samples) { return uint(frame.viewport.x) * uint(frame.viewport.y) * uint(samples); }
uint sampleIndex(ivec2 pixel, int samples, int i) {
    return (uint(pixel.y) * uint(frame.viewport.x) + uint(pixel.x)) * uint(samples) + uint(i);
}

#ifdef WIDE_ATOMICS
uint depthOfSample(uint at) { return unpackUint2x32(visible[at]).y; }
#else
uint nameWord(uint at) { return 2u * at; }
uint depthWord(uint at) { return 2u * at + 1u; }
uint depthOfSample(uint at) { return visible[depthWord(at)]; }
#endif

// Cracks, added up by those that cross: minus the logarithm of what they leave of the material, in steps, in the low half;
// what shows of walls in the high one.
const float kCrackSteps = 64.0;  // for a factor of 2
const float kWallSteps = 1023.0;  // for all of it
uint crackWord(ivec2 pixel, int samples, int i) {
    return 2u * sampleTotal(samples) + sampleIndex(pixel, samples, i);
}
