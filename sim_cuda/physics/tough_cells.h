// Set-up: tough cells, the inner structure that makes a body break into chunks and not into dust (models
// E.3): bonds inside one cell are `tough_factor` times stronger.
#pragma once
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim_cuda/physics/random.h"
#include "sim_cuda/physics/vector.h"

namespace demolish {

namespace tough_detail {
/// One component of smooth value noise in [-1, 1]: lattice values by hash, quintic fade between them.
inline double valueNoise(const Vec3<double>& p, uint64_t seed) {
    const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
    const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const double t[3] = {fade(p.x - fx), fade(p.y - fy), fade(p.z - fz)};
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= (corner >> axis & 1) ? t[axis] : 1 - t[axis];
        const auto cell = [&](double base, int axis) {
            return static_cast<uint64_t>(static_cast<int64_t>(base) + (corner >> axis & 1));
        };
        const uint64_t key = counterHash(counterHash(cell(fx, 0), cell(fy, 1)), cell(fz, 2));
        sum += weight * (2 * uniformOf(seed, key) - 1);
    }
    return sum;
}
}  // namespace tough_detail

/// Shift (m) of a particle before it is labelled: two octaves of noise, wavelength 0.6 Lc, amplitude 0.25 Lc,
/// so that crack paths between cells come out curved. Lc = (V/K)^(1/3), m; |component| <= 0.25 Lc.
inline Vec3<double> labelShift(const Vec3<double>& x, double cell_length, uint64_t seed) {
    const Vec3<double> p = (1 / (0.6 * cell_length)) * x;
    double component[3];
    for (uint64_t axis = 0; axis < 3; ++axis)
        component[axis] = (tough_detail::valueNoise(p, counterHash(seed, 2 * axis)) +
                           0.5 * tough_detail::valueNoise(2.0 * p, counterHash(seed, 2 * axis + 1))) /
                          1.5;
    return (0.25 * cell_length) * Vec3<double>{component[0], component[1], component[2]};
}

/// Label of each particle: the nearest of K seeds (lowest index wins a tie) after labelShift. The seeds are K
/// different particle positions drawn by hash. Positions in m, volume in m^3; K >= number of particles gives
/// each its own label.
inline std::vector<uint32_t> toughCellLabels(const std::vector<Vec3<double>>& positions, double volume,
                                             uint32_t cells, uint64_t seed) {
    const size_t count = positions.size();
    std::vector<uint32_t> labels(count, 0), order(count);
    for (size_t i = 0; i < count; ++i) order[i] = static_cast<uint32_t>(i);
    if (cells >= count) return order;
    for (uint32_t k = 0; k < cells; ++k) std::swap(order[k], order[k + counterHash(seed, k) % (count - k)]);
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
