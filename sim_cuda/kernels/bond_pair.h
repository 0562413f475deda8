// SPDX-License-Identifier: Apache-2.0
// One solid bond as its particle i sees it: load, break test, and what it books. Straight-line code, so that
// the CPU can do eight bonds at once; odd in i and j to the last bit, so that both ends agree.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/step_params.h"
#include "sim_cuda/physics/bond_laws.h"
#include "sim_cuda/physics/broken_bond.h"

namespace demolish {

/// Two particles as a pair law sees them.
template <class Real>
struct PairMotion {
    Vec3<Real> separation;  ///< x_j - x_i, m
    Quat<Real> rotation_i, rotation_j;
    Vec3<Real> velocity_i, velocity_j, spin_i, spin_j;
};

template <class Real>
struct BondConstants {
    Vec3<Real> rest;  ///< m, x_j - x_i at rest
    BondStiffness<Real> stiffness;
    Real radius{};    ///< m, a_b
    Real strength{};  ///< Pa, s_b sigma_c
    Real beta_r{};    ///< s
};

/// (E1): k_B = k_N a_b^2 / 4, k_T = a k_N, k_P = 2 a k_B; the paper's (5')-(10') with psi = 0 have the same
/// ratios, with a = 2 (1 - nu) / (2 - nu).
template <class Real>
DEM_FN BondConstants<Real> bondConstants(const Vec4<Real>& rest, uint32_t grade, const BodyLaw<Real>& law) {
    const Real radius = law.radius_unit * static_cast<Real>(gradeRadius(grade));
    const Real bending = rest.w * (Real(0.25) * radius * radius);
    return {xyz(rest),
            {rest.w, law.shear_ratio * rest.w, bending, Real(2) * law.shear_ratio * bending},
            radius,
            law.strength_unit * static_cast<Real>(gradeStrength(grade)),
            law.beta_r};
}

/// What one bond does in this substep.
template <class Real>
struct BondEffect {
    Vec3<Real> force;     ///< N, on i; j gets the opposite
    Vec3<Real> torque_i;  ///< N m, on i about its centre
    Vec3<Real> torque_j;  ///< N m: j gets the opposite of this
    Real severity{};      ///< N m: (E2) times A a_b; the bond breaks when it reaches `limit`
    Real limit{};         ///< N m: s_b sigma_c pi a_b^3
};

/// (11') (12') without a division: stress times pi a_b^3.
template <class Real>
DEM_FN Real bondSeverity(const BondLoad<Real>& load, Real radius) {
    const Real tension = madd(load.normal_force, radius, Real(4) * length(load.bending_moment));
    const Real shear = madd(length(load.shear_force), radius, Real(2) * absOf(load.torsion_moment));
    return maxOf(tension, shear);
}

/// The vector from i's centre to j's centre at rest takes the place of normal and lengths: shares 1/2 and 1/2
/// of it (the face lies on the bisector).
template <class Real>
DEM_FN BondDeformation<Real> faceBondDeformation(const BondConstants<Real>& bond,
                                                 const PairMotion<Real>& pair) {
    return bondDeformation(BondRest<Real>{bond.rest, Real(0.5), Real(0.5)}, pair.separation, pair.rotation_i,
                           pair.rotation_j);
}

/// F = N n + T, M = M_N n + M_T; tau_i = M + P_i x F (B.2), and for j the same at its own arm.
template <class Real>
DEM_FN BondEffect<Real> loadEffect(const BondLoad<Real>& load, const BondDeformation<Real>& d) {
    const Vec3<Real> moment = axpy(load.torsion_moment, d.normal, load.bending_moment);
    BondEffect<Real> effect;
    effect.force = axpy(load.normal_force, d.normal, load.shear_force);
    effect.torque_i = moment + cross(d.arm_i, effect.force);
    effect.torque_j = moment + cross(d.arm_j, effect.force);
    return effect;
}

/// B.2, E1-E3.
template <class Real>
DEM_FN BondEffect<Real> bondEffect(const BondConstants<Real>& bond, const PairMotion<Real>& pair) {
    const BondDeformation<Real> d = faceBondDeformation(bond, pair);
    const BondRates<Real> rates = bondRates(d, pair.velocity_i, pair.spin_i, pair.velocity_j, pair.spin_j);
    const BondLoad<Real> elastic = bondLoad(bond.stiffness, d);
    BondEffect<Real> effect = loadEffect(dampedBondLoad(elastic, bond.stiffness, d, rates, bond.beta_r), d);
    effect.severity = bondSeverity(elastic, bond.radius);
    effect.limit = Real(kPi) * bond.strength * (bond.radius * bond.radius * bond.radius);
    return effect;
}

/// The damper's share of force and torques, for the ledger.
template <class Real>
DEM_FN BondEffect<Real> bondDamping(const BondConstants<Real>& bond, const PairMotion<Real>& pair) {
    const BondDeformation<Real> d = faceBondDeformation(bond, pair);
    const BondRates<Real> rates = bondRates(d, pair.velocity_i, pair.spin_i, pair.velocity_j, pair.spin_j);
    return loadEffect(dampedBondLoad(BondLoad<Real>{}, bond.stiffness, d, rates, bond.beta_r), d);
}

/// J, leaves with the bond if it breaks in this substep: it still pulls through this kick, so its energy half
/// a step later, less what the compressed faces keep (A.6).
template <class Real>
DEM_FN Real bondFractureEnergy(const BondConstants<Real>& bond, const PairMotion<Real>& pair, Real dt) {
    const BondDeformation<Real> d = faceBondDeformation(bond, pair);
    const BondRates<Real> rates = bondRates(d, pair.velocity_i, pair.spin_i, pair.velocity_j, pair.spin_j);
    const BondLoad<Real> elastic = bondLoad(bond.stiffness, d);
    const Vec3<Real> force = axpy(elastic.normal_force, d.normal, elastic.shear_force);
    const Vec3<Real> moment = axpy(elastic.torsion_moment, d.normal, elastic.bending_moment);
    const Real power = dot(force, rates.velocity) + dot(moment, rates.spin);
    const Real energy = madd(Real(0.5) * dt, power, bondEnergy(bond.stiffness, d));
    const Real overlap = brokenOverlap(length(bond.rest), length(pair.separation));
    return fractureEnergy(energy, bond.stiffness.normal, overlap);
}

}  // namespace demolish
