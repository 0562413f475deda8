// SPDX-License-Identifier: Apache-2.0
// Packed vertices as a shader reads them.
#pragma once
#include <bit>
#include <cstdint>

namespace demolish::test {

inline float unpackSnorm16(uint32_t bits) {
    return static_cast<float>(static_cast<int16_t>(bits & 0xffffu)) / 32767.0f;
}

/// Not normalised: lies on the octahedron |x| + |y| + |z| = 1.
inline void unpackOctahedral(uint32_t packed, float& x, float& y, float& z) {
    const float u = unpackSnorm16(packed), v = unpackSnorm16(packed >> 16);
    const float au = u < 0.0f ? -u : u, av = v < 0.0f ? -v : v;
    x = u;
    y = v;
    z = 1.0f - au - av;
    if (z < 0.0f) {
        x = (1.0f - av) * (u < 0.0f ? -1.0f : 1.0f);
        y = (1.0f - au) * (v < 0.0f ? -1.0f : 1.0f);
    }
}

inline float unpackHalf(uint32_t half) {
    const uint32_t sign = (half & 0x8000u) << 16;
    const uint32_t exponent = half >> 10 & 0x1fu, mantissa = half & 0x3ffu;
    if (exponent == 0) {
        const float magnitude = static_cast<float>(mantissa) * 5.9604644775390625e-8f;  // 2^-24
        return sign != 0 ? -magnitude : magnitude;
    }
    return std::bit_cast<float>(sign | (exponent + 112u) << 23 | mantissa << 13);
}

}  // namespace demolish::test
