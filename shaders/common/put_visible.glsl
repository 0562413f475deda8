// SPDX-License-Identifier: Apache-2.0
// The nearest triangle of each sample of the picture.
#include "common/visible.glsl"

vec2 cameraSize() { return frame.viewport.xy; }

vec4 clipOf(vec3 p) { return frame.view_projection * vec4(p, 1.0); }

// Not what near faces replace.
bool isShown(uint name) {
    if (near_command[0] == 0u || (name & kNearBits) != kInteriorBit) return true;
    BodyVertex v[3];
    fetchTriangle(name, v);
    return !isReplaced(v[0].cell);
}

// `held`: a depth that the sample has had, as bits, and by now perhaps a nearer one.
void putSample(uint at, uint bits, uint name, uint held) {
#ifdef WIDE_ATOMICS
    atomicMax(visible[at], packUint2x32(uvec2(name, bits)));
#else
    if (naming == 0) atomicMax(visible[depthWord(at)], bits);
    else if (bits == held) atomicMax(visible[nameWord(at)], name);
#endif
}

// Covered samples of a pixel, a bit each. May they show the triangle, as far as one knows by now?
bool putCamera(Flat f, ivec2 pixel, uint covered, uint name) {
    uint place = sampleIndex(pixel, SAMPLES, 0), held[SAMPLES];
    for (int i = 0; i < SAMPLES; ++i) held[i] = depthOfSample(place + uint(i));  // all are fetched before one is waited for
    bool shows = false;
    for (int i = 0; i < SAMPLES; ++i) {
        float depth = depthAt(f, kGrid * pixel + sample_at[i]);
        uint bits = floatBitsToUint(depth);
        if ((covered >> i & 1u) == 0u || depth <= 0.0 || depth > 1.0 || bits < held[i]) continue;
        shows = true;
        putSample(place + uint(i), bits, name, held[i]);
    }
    return shows;
}
