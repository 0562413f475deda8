// How slender a body is, and from which share of its threshold on its pieces therefore wake.
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/physics/hand_over.h"

namespace demolish {

/// Radius of gyration over half the edge of the cube of the same volume: 1 for a cube, 1.16 for the rabbit,
/// 1.6 for the wolf, 2.0 for the vase's wall, 2.3 for the column. For a bar of length L and thickness t it
/// goes as (L / t)^(2/3). 0 for a body without volume.
inline double spreadOf(const BreakableBody& body) {
    double volume = 0, second = 0;
    Double3 first;
    for (const Particle& p : body.particles) {
        volume += p.volume;
        first.x += p.volume * p.centroid.x;
        first.y += p.volume * p.centroid.y;
        first.z += p.volume * p.centroid.z;
        second += p.volume * (p.centroid.x * p.centroid.x + p.centroid.y * p.centroid.y +
                              p.centroid.z * p.centroid.z) +
                  0.5 * (p.inertia.xx + p.inertia.yy + p.inertia.zz);
    }
    if (!(volume > 0)) return 0;
    const double centre2 = (first.x * first.x + first.y * first.y + first.z * first.z) / (volume * volume);
    return 2 * std::sqrt(std::max(second / volume - centre2, 0.0)) / std::cbrt(volume);
}

/// Of pieces of a body of such a spread: a hit at the end of a lever bends what is thin, and breaks it the
/// sooner the longer the lever is. Rounded, so that it is the same on every machine.
inline double wakeShare(double spread) {
    const double share = kWakeShare / std::max(spread * spread, 0.1);
    return std::round(1000 * std::clamp(share, kLeastWakeShare, kMostWakeShare)) / 1000;
}

}  // namespace demolish
