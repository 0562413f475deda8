// SPDX-License-Identifier: Apache-2.0
// The nearest faces of transparent bodies before what is opaque. SAMPLES is 1: of a picture ACROSS times as wide.
#include "common/faces.glsl"
#if PICTURE_SAMPLES > 1
layout(binding = 7) uniform sampler2DMS opaque_depth;
#else
layout(binding = 7) uniform sampler2D opaque_depth;
#endif

vec2 cameraSize() { return float(ACROSS) * frame.viewport.xy; }

vec4 clipOf(vec3 p) { return frame.view_projection * vec4(p, 1.0); }

// Each place keeps the nearest that comes by and hands the other on, so that in the end they hold the nearest in order,
// whatever order they came in. Has it found a place?
bool keepFace(uint first, uint bits) {
    if (bits <= faces[first + uint(KEPT - 1)]) return false;
    for (uint k = 0u; k < uint(KEPT); ++k) {
        uint held = atomicMax(faces[first + k], bits);
        if (held == 0u || held == bits) return true;
        bits = min(bits, held);
    }
    return true;
}

bool putCamera(Flat f, ivec2 at, uint covered, uint name) {
    float depth = depthAt(f, kGrid * at + sample_at[0]);
    if (depth > 1.0 || depth <= texelFetch(opaque_depth, at / ACROSS, 0).r) return false;
    uint bits = floatBitsToUint(depth), first = facePlace(at);
    if (naming == 0) return keepFace(first, bits);
    for (uint k = 0u; k < uint(KEPT); ++k) {
        if (faces[first + k] == bits) atomicMax(faces[faceNames() + first + k], name);
    }
    return true;
}
