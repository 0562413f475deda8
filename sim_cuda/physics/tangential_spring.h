// SPDX-License-Identifier: Apache-2.0
// Friction with a direction: the tangential spring of a contact, capped by Coulomb's law on magnitudes: (2')
// (4') (15').
#pragma once
#include "sim_cuda/physics/vector.h"

namespace demolish {

/// (2') (4') (15'): mu times the repulsive force (N, >= 0) alone, so that adhesion never turns friction
/// round.
template <class T>
DEM_FN T frictionLimit(T friction, T repulsive_force) {
    return friction * repulsive_force;
}

/// Of particle i in the contact i-j; j's are the exact opposites.
template <class T>
struct TangentialResult {
    Vec3<T> spring;  ///< m, xi after the step: slip of j relative to i that the spring still holds
    Vec3<T> force;   ///< N, on i
    bool sliding = false;
};

/// The spring carried to the present contact plane: projected on it, its length kept. `normal` is unit.
template <class T>
DEM_FN Vec3<T> turnedIntoPlane(const Vec3<T>& spring, const Vec3<T>& normal) {
    const Vec3<T> flat = axpy(-dot(spring, normal), normal, spring);
    return (length(spring) * inverseSqrt(length2(flat))) * flat;
}

/// Advances the spring by dt (s). `slip` = tangential velocity of j's surface point minus i's, m/s;
/// `stiffness` k_t > 0, N/m; `damping` N s/m; `limit` = frictionLimit(), N. Force on i = k_t xi + c slip, no
/// longer than the limit; the spring by itself is shortened to limit / k_t. What the damper alone drives
/// beyond the limit leaves the spring as it is: a spring that had to hold the whole capped force would be
/// loaded with energy that nobody put in, and never let a crumb come to rest. So the contact takes in at
/// least what its spring holds more. Odd in (spring, normal, slip).
template <class T>
DEM_FN TangentialResult<T> tangentialSpring(const Vec3<T>& spring, const Vec3<T>& normal, const Vec3<T>& slip,
                                            T dt, T stiffness, T damping, T limit) {
    const T limit2 = limit * limit;
    TangentialResult<T> result{axpy(dt, slip, turnedIntoPlane(spring, normal)), {}, false};
    if (const T held2 = stiffness * stiffness * length2(result.spring); held2 > limit2) {
        result.spring = (limit * inverseSqrt(held2)) * result.spring;
        result.sliding = true;
    }
    result.force = axpy(damping, slip, stiffness * result.spring);
    if (const T size2 = length2(result.force); size2 > limit2) {
        result.force = (limit * inverseSqrt(size2)) * result.force;
        result.sliding = true;
    }
    return result;
}

}  // namespace demolish
