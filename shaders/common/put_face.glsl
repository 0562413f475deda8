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

// Leaves the nearer one in a place; what it held.
uvec2 leaveNearer(uint place, uvec2 face) {
#ifdef WIDE_ATOMICS
    return unpackUint2x32(atomicMax(wide_faces[place], packUint2x32(face)));
#else
    return uvec2(0u, atomicMax(faces[place].y, face.y));
#endif
}

// Each place keeps the nearest that comes by and hands the other on, so that in the end they hold the nearest in order,
// whatever order they came in. Of two at one depth the higher name stays. Has it found a place?
bool keepFace(ivec2 at, uvec2 face) {
    uvec2 last = faceAt(facePlace(at, uint(KEPT - 1)));
    if (face.y < last.y || (face.y == last.y && face.x <= last.x)) return false;
    for (uint k = 0u; k < uint(KEPT); ++k) {
        uvec2 held = leaveNearer(facePlace(at, k), face);
        if (held.y == 0u || held.y == face.y) return true;
        if (held.y < face.y) face = held;
    }
    return true;
}

bool putCamera(Flat f, ivec2 at, uint covered, uint name) {
    float depth = depthAt(f, kGrid * at + sample_at[0]);
    if (depth > 1.0 || depth <= texelFetch(opaque_depth, at / ACROSS, 0).r) return false;
    uint bits = floatBitsToUint(depth);
    if (naming == 0) return keepFace(at, uvec2(name, bits));
#ifndef WIDE_ATOMICS
    for (uint k = 0u; k < uint(KEPT); ++k) {
        uint place = facePlace(at, k);
        if (faces[place].y == bits) atomicMax(faces[place].x, name);
    }
#endif
    return true;
}
