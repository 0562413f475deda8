// SPDX-License-Identifier: Apache-2.0
// Stable step of the leapfrog (physics B.3): undamped limit, damped limit, and a bound that needs no
// eigenvalues.
#pragma once
#include <cmath>

#include "sim_cuda/physics/bond_laws.h"

namespace demolish {

/// One end of a bond, for the bound: mass (kg), inertia (kg m^2), number of bonds, distance to the common
/// point (m).
struct BondEnd {
    double mass = 0, inertia = 0, bonds = 0, arm = 0;
};

/// Upper bound of omega_max^2 (rad^2/s^2) from one bond: each particle's mass is shared among its z bonds.
/// The largest value over all bonds bounds the largest eigenvalue of M^-1 K, translation and rotation.
inline double frequencyBoundSquared(const BondStiffness<double>& k, const BondEnd& i, const BondEnd& j) {
    const double m = i.bonds / i.mass + j.bonds / j.mass, r = i.bonds / i.inertia + j.bonds / j.inertia;
    const double s =
        k.shear * (m + i.bonds * i.arm * i.arm / i.inertia + j.bonds * j.arm * j.arm / j.inertia);
    const double b = k.bending * r;
    const double p =
        std::sqrt(k.shear * k.bending) * (i.bonds * i.arm / i.inertia - j.bonds * j.arm / j.inertia);
    const double shear_bending = (s + b) / 2 + std::sqrt((s - b) * (s - b) / 4 + p * p);
    return std::fmax(k.normal * m, std::fmax(k.torsion * r, shear_bending));
}

/// dt_crit = 2/omega_max, s, undamped; omega in rad/s.
inline double criticalStep(double omega_max) {
    return 2 / omega_max;
}

/// Largest share of dt_crit with lagged damping: sqrt(1+zeta_m^2) - zeta_m; zeta_m = damping ratio of the
/// highest mode.
inline double dampedStepShare(double zeta_m) {
    return std::sqrt(1 + zeta_m * zeta_m) - zeta_m;
}

/// (E3) beta_R = 2 zeta_m/omega_max, s.
inline double stiffnessDamping(double zeta_m, double omega_max) {
    return 2 * zeta_m / omega_max;
}

/// dt = safety * 2/omega_max, s, never above the damped limit. Safety in (0, 1), 0.5 by default (physics
/// B.3).
inline double stableStep(double omega_max, double zeta_m, double safety = 0.5) {
    return std::fmin(safety, dampedStepShare(zeta_m)) * criticalStep(omega_max);
}

}  // namespace demolish
