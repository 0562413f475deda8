// SPDX-License-Identifier: Apache-2.0
// The box that holds all velocities: minima and maxima, so that no order of evaluation can change it.
#pragma once
#include <cmath>

#include "sim_cuda/data/contact_rows.h"

namespace demolish {

/// m/s; empty: low above high.
template <class Real>
struct VelocityRange {
    Vec3<Real> low{Real(1e30), Real(1e30), Real(1e30)}, high{Real(-1e30), Real(-1e30), Real(-1e30)};
};

template <class Real>
struct VelocityRanges {
    VelocityRange<Real> bodies, projectiles;
};

template <class Real>
struct WidenRanges {
    DEM_FN static void widen(VelocityRange<Real>& into, const VelocityRange<Real>& other) {
        into.low = {minOf(into.low.x, other.low.x), minOf(into.low.y, other.low.y),
                    minOf(into.low.z, other.low.z)};
        into.high = {maxOf(into.high.x, other.high.x), maxOf(into.high.y, other.high.y),
                     maxOf(into.high.z, other.high.z)};
    }
    DEM_FN void operator()(VelocityRanges<Real>& into, const VelocityRanges<Real>& other) const {
        widen(into.bodies, other.bodies);
        widen(into.projectiles, other.projectiles);
    }
};

template <class Real>
DEM_FN Vec3<Real> middleOf(const VelocityRange<Real>& range) {
    if (!(range.low.x <= range.high.x)) return {};
    return Real(0.5) * (range.low + range.high);
}

DEM_FN double farthestFrom(double low, double high, double from) {
    return maxOf(absOf(low - from), absOf(high - from));
}

/// Upper bound of |v - common| over the box, m/s; 0 for an empty one.
template <class Real>
DEM_FN double largestSpeed(const VelocityRange<Real>& range, const Vec3<Real>& common) {
    if (!(range.low.x <= range.high.x)) return 0;
    const double x = farthestFrom(range.low.x, range.high.x, common.x),
                 y = farthestFrom(range.low.y, range.high.y, common.y),
                 z = farthestFrom(range.low.z, range.high.z, common.z);
    return std::sqrt(x * x + y * y + z * z);
}

}  // namespace demolish
