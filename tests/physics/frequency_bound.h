// SPDX-License-Identifier: Apache-2.0
// A bound of the highest frequency that needs no eigenvalues (physics.md B.3): what the solver's own estimate
// is held against.
#pragma once
#include <cmath>

#include "sim_cuda/physics/bond_laws.h"

namespace demolish::test {

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

}  // namespace demolish::test
