// SPDX-License-Identifier: Apache-2.0
// Roughness of broken material: a smooth random vector field made of hashed lattices; the same bits
// everywhere.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/vector.h"

namespace demolish {

/// Integer lattice point to 32 well-mixed bits.
DEM_FN uint32_t hashLattice(int32_t x, int32_t y, int32_t z, uint32_t salt) {
    uint32_t h = static_cast<uint32_t>(x) * 0x8da6b343u ^ static_cast<uint32_t>(y) * 0xd8163841u ^
                 static_cast<uint32_t>(z) * 0xcb1ab31fu ^ salt * 0x9e3779b9u;
    h = (h ^ h >> 16) * 0x7feb352du;
    h = (h ^ h >> 15) * 0x846ca68bu;
    return h ^ h >> 16;
}

/// Three independent values in [-1, 1], ten bits each.
DEM_FN Vec3<float> latticeVector(int32_t x, int32_t y, int32_t z, uint32_t salt) {
    const uint32_t h = hashLattice(x, y, z, salt);
    const float scale = 2.0f / 1023.0f;
    return {static_cast<float>(h & 1023u) * scale - 1.0f, static_cast<float>(h >> 10 & 1023u) * scale - 1.0f,
            static_cast<float>(h >> 20 & 1023u) * scale - 1.0f};
}

/// One octave: wavelength 1, each component in [-1, 1], continuous with its first derivative.
DEM_FN Vec3<float> valueNoise(const Vec3<float>& p, uint32_t salt) {
    const auto below = [](float v) {
        const int32_t whole = static_cast<int32_t>(v);
        return static_cast<float>(whole) > v ? whole - 1 : whole;
    };
    const auto smooth = [](float t) { return t * t * (3.0f - 2.0f * t); };
    const int32_t ix = below(p.x), iy = below(p.y), iz = below(p.z);
    const float u = smooth(p.x - static_cast<float>(ix)), v = smooth(p.y - static_cast<float>(iy));
    const float w = smooth(p.z - static_cast<float>(iz));
    Vec3<float> sum;
    for (int32_t corner = 0; corner < 8; ++corner) {
        const int32_t dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const float weight = (dx != 0 ? u : 1.0f - u) * (dy != 0 ? v : 1.0f - v) * (dz != 0 ? w : 1.0f - w);
        sum = axpy(weight, latticeVector(ix + dx, iy + dy, iz + dz, salt), sum);
    }
    return sum;
}

/// Three octaves of gain 1/2 (geometry.md 4 b): first wavelength 1, each component within 1.75. The lattices
/// are shifted and not quite harmonic, so that their planes do not show.
DEM_FN Vec3<float> roughnessNoise(const Vec3<float>& p) {
    const Vec3<float> shift{17.31f, 5.77f, 11.93f};
    Vec3<float> sum = valueNoise(p + shift, 1);
    sum = axpy(0.5f, valueNoise(2.03f * p + shift, 2), sum);
    return axpy(0.25f, valueNoise(4.11f * p + shift, 3), sum);
}
/// Largest length of roughnessNoise: 1.75 sqrt(3).
inline constexpr float kRoughnessNoiseBound = 3.0311f;

}  // namespace demolish
