// SPDX-License-Identifier: Apache-2.0
// What ends the motion of round cells: rolling resistance (models E.5).
#pragma once
#include "sim_cuda/physics/vector.h"

namespace demolish {

/// Torque on i, N m, against the spin of j relative to i (rad/s): size min(mu_r R N, 0.2 I |w| / dt), so that
/// one step takes at most a fifth of the relative spin. R = radius (m), N = normal force (N, >= 0), I =
/// inertia (kg m^2); for two particles use the reduced values, for a wall i's own and relative_spin = -w_i.
/// Odd in relative_spin.
template <class T>
DEM_FN Vec3<T> rollingTorque(T rolling_friction, T radius, T normal_force, T inertia,
                             const Vec3<T>& relative_spin, T dt) {
    const T inverse = inverseSqrt(length2(relative_spin));
    const T size = rolling_friction * radius * normal_force * inverse;
    return minOf(size, T(0.2) * inertia / dt) * relative_spin;
}

}  // namespace demolish
