// Friction with a direction: the tangential spring of a contact, capped by Coulomb's law on magnitudes: (2')
// (4') (15').
#pragma once
#include "sim_cuda/physics/vector.h"

namespace demolish {

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
/// `stiffness` k_t > 0, N/m; `damping` N s/m; `limit` = mu times the repulsive normal force, N, >= 0. Force
/// on i = k_t xi + c slip, no longer than the limit; while sliding the spring is shortened to limit / k_t.
/// Odd in (spring, normal, slip).
template <class T>
DEM_FN TangentialResult<T> tangentialSpring(const Vec3<T>& spring, const Vec3<T>& normal, const Vec3<T>& slip,
                                            T dt, T stiffness, T damping, T limit) {
    const Vec3<T> xi = axpy(dt, slip, turnedIntoPlane(spring, normal));
    const Vec3<T> trial = axpy(damping, slip, stiffness * xi);
    const T size2 = length2(trial);
    if (!(size2 > limit * limit)) return {xi, trial, false};
    const Vec3<T> capped = (limit * inverseSqrt(size2)) * trial;
    return {(T(1) / stiffness) * capped, capped, true};
}

}  // namespace demolish
