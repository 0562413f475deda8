// SPDX-License-Identifier: Apache-2.0
// Set-up: tough cells, the inner structure that makes a body break into chunks and not into dust (models
// E.3): bonds inside one cell are `tough_factor` times stronger.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim_cuda/physics/random.h"
#include "sim_cuda/physics/value_noise.h"
#include "sim_cuda/physics/vector.h"

namespace demolish {

/// Shift (m) of a particle before it is labelled: two octaves of noise, wavelength 0.6 Lc, amplitude 0.25 Lc,
/// so that crack paths between cells come out curved. Lc = (V/K)^(1/3), m; |component| <= 0.25 Lc.
inline Vec3<double> labelShift(const Vec3<double>& x, double cell_length, uint64_t seed) {
    const double scale = 1 / (0.6 * cell_length);
    const Vec3<float> p{static_cast<float>(scale * x.x), static_cast<float>(scale * x.y),
                        static_cast<float>(scale * x.z)};
    const Vec3<float> coarse = valueNoise(p, static_cast<uint32_t>(counterHash(seed, 0)));
    const Vec3<float> fine = valueNoise(2.0f * p, static_cast<uint32_t>(counterHash(seed, 1)));
    const Vec3<float> sum = axpy(0.5f, fine, coarse);
    return (0.25 / 1.5 * cell_length) * Vec3<double>{sum.x, sum.y, sum.z};
}

/// The particles of `count` whose places are the seeds of `cells` tough cells, fewer than particles: drawn by
/// hash, all different.
inline std::vector<uint32_t> toughCellSeeds(size_t count, uint32_t cells, uint64_t seed) {
    std::vector<uint32_t> order(count);
    for (size_t i = 0; i < count; ++i) order[i] = static_cast<uint32_t>(i);
    for (uint32_t k = 0; k < cells; ++k) std::swap(order[k], order[k + counterHash(seed, k) % (count - k)]);
    order.resize(cells);
    return order;
}

/// Label of each particle: the nearest of K seeds (lowest index wins a tie) after labelShift. The seeds are K
/// different particle positions drawn by hash. Positions in m, volume in m^3; K >= number of particles gives
/// each its own label.
inline std::vector<uint32_t> toughCellLabels(const std::vector<Vec3<double>>& positions, double volume,
                                             uint32_t cells, uint64_t seed) {
    const size_t count = positions.size();
    std::vector<uint32_t> labels(count, 0);
    if (cells >= count) {
        for (size_t i = 0; i < count; ++i) labels[i] = static_cast<uint32_t>(i);
        return labels;
    }
    const std::vector<uint32_t> order = toughCellSeeds(count, cells, seed);
    const double cell_length = std::cbrt(volume / cells);
    for (size_t i = 0; i < count; ++i) {
        const Vec3<double> p = positions[i] + labelShift(positions[i], cell_length, seed);
        double nearest = 0;
        for (uint32_t k = 0; k < cells; ++k) {
            const double d2 = length2(p - positions[order[k]]);
            if (k > 0 && !(d2 < nearest)) continue;
            nearest = d2;
            labels[i] = k;
        }
    }
    return labels;
}

}  // namespace demolish
