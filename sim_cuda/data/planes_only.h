// SPDX-License-Identifier: Apache-2.0
// Colliders as a kernel sees them that is compiled for planes alone, as most scenes have them.
#pragma once
#include "sim_cuda/data/colliders.h"

namespace demolish {

/// A set of nothing but planes. A kernel that knows need not tell shapes apart: what the others want in
/// registers costs every particle.
template <class Real>
struct PlanesOnly {
    const ColliderSet<Real>& set;
    const uint32_t count = set.count;

    DEM_FN static constexpr bool isPlane(uint32_t) { return true; }
    DEM_FN static constexpr bool isMesh(uint32_t) { return false; }
    DEM_FN TangentPlane<Real> tangent(uint32_t c, const Vec3<Real>& high, const Vec3<Real>& low = {}) const {
        return tangentOfPlane(set.collider[c].row[0], high, low);
    }
    DEM_FN TangentPlane<Real> bound(uint32_t c, const Vec3<Real>& high, const Vec3<Real>& low = {}) const {
        return tangent(c, high, low);
    }
};
/// PlanesOnly, or the set itself.
template <bool kOnlyPlanes, class Real>
DEM_FN decltype(auto) seenColliders(const ColliderSet<Real>& set) {
    if constexpr (kOnlyPlanes)
        return PlanesOnly<Real>{set};
    else
        return (set);
}

}  // namespace demolish
