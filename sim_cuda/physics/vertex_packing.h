// SPDX-License-Identifier: Apache-2.0
// Small vertices: directions as two 16-bit numbers, texture coordinates as two halves; the same bits on host
// and device.
#pragma once
#include <bit>
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

/// -1..1 as a signed 16-bit fraction of 32767; rounds to nearest, clamps.
DEM_FN uint32_t packSnorm16(float value) {
    const float clamped = value < -1.0f ? -1.0f : (value > 1.0f ? 1.0f : value);
    const float scaled = clamped * 32767.0f;
    const int rounded = static_cast<int>(scaled + (scaled < 0.0f ? -0.5f : 0.5f));
    return static_cast<uint32_t>(rounded) & 0xffffu;
}

/// Octahedral direction: 2 x snorm16, x in the low half. Any length but zero; zero gives +z.
DEM_FN uint32_t packOctahedral(float x, float y, float z) {
    const float ax = x < 0.0f ? -x : x, ay = y < 0.0f ? -y : y, az = z < 0.0f ? -z : z;
    const float sum = ax + ay + az;
    if (!(sum > 0.0f)) return 0;
    float u = x / sum, v = y / sum;
    if (z < 0.0f) {  // fold the lower half over the diagonals
        const float folded_u = (1.0f - ay / sum) * (x < 0.0f ? -1.0f : 1.0f);
        const float folded_v = (1.0f - ax / sum) * (y < 0.0f ? -1.0f : 1.0f);
        u = folded_u;
        v = folded_v;
    }
    return packSnorm16(u) | packSnorm16(v) << 16;
}

/// IEEE half, rounded to nearest even; beyond +-65504 it stops there, NaN becomes 0.
DEM_FN uint32_t packHalf(float value) {
    uint32_t bits = std::bit_cast<uint32_t>(value);
    const uint32_t sign = bits >> 16 & 0x8000u;
    bits &= 0x7fffffffu;
    if (bits > 0x7f800000u) return 0;
    if (bits >= 0x477ff000u) return sign | 0x7bffu;
    if (bits < 0x38800000u) {  // a subnormal half: let the addition do the rounding
        const float rounded = std::bit_cast<float>(bits) + 0.5f;
        return sign | (std::bit_cast<uint32_t>(rounded) - 0x3f000000u);
    }
    const uint32_t odd = bits >> 13 & 1u;
    return sign | ((bits + 0xc8000fffu + odd) >> 13);
}

/// 2 x half, u in the low half.
DEM_FN uint32_t packHalf2(float u, float v) {
    return packHalf(u) | packHalf(v) << 16;
}

}  // namespace demolish
