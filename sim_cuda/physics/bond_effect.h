// SPDX-License-Identifier: Apache-2.0
// One solid bond in one substep: load on both ends, verdict, and what the ledger books. Straight-line code,
// so that the CPU can do many bonds at once; odd in i and j to the last bit, so that both ends agree.
#pragma once
#include "sim_cuda/physics/bond_laws.h"
#include "sim_cuda/physics/broken_bond.h"

namespace demolish {

template <class T>
struct BondConstants {
    Vec3<T> rest;  ///< m, x_j - x_i at rest
    BondStiffness<T> stiffness;
    T radius{};    ///< m, a_b
    T strength{};  ///< Pa, s_b sigma_c
    T beta_r{};    ///< s
};

/// What one bond does in this substep.
template <class T>
struct BondEffect {
    Vec3<T> force;     ///< N, on i; j gets the opposite
    Vec3<T> torque_i;  ///< N m, on i about its centre
    Vec3<T> torque_j;  ///< N m: j gets the opposite of this
    T severity{};      ///< N m: bondSeverity()
    T limit{};         ///< N m: severityLimit()
};

/// F = N n + T, M = M_N n + M_T; tau_i = M + P_i x F (B.2), and for j the same at its own arm: dampers.
template <class T>
DEM_FN BondEffect<T> loadEffect(const BondLoad<T>& load, const BondDeformation<T>& d) {
    const Vec3<T> moment = axpy(load.torsion_moment, d.normal, load.bending_moment);
    BondEffect<T> effect;
    effect.force = axpy(load.normal_force, d.normal, load.shear_force);
    effect.torque_i = moment + cross(d.arm_i, effect.force);
    effect.torque_j = moment + cross(d.arm_j, effect.force);
    return effect;
}

/// What the bond's springs do: minus the slope of bondEnergy() by either end's place and turning, however far
/// the two are bent (B.2). Up to the second order that is loadEffect(load, d). Beyond, twist and bending mix
/// where they differ in stiffness, and n turns otherwise than either end: with loadEffect() a needle that
/// bent by radians gained two fifths of a shot's energy. In a folded bond n changes its length, too.
template <class T>
DEM_FN BondEffect<T> elasticEffect(const BondStiffness<T>& k, const BondLoad<T>& load,
                                   const BondDeformation<T>& d) {
    const T by_stretch = (k.normal - k.shear) * d.stretch, by_twist = (k.torsion - k.bending) * d.twist;
    const T by_length = d.folded ? madd(by_stretch, d.stretch, by_twist * d.twist) : T(0);
    const Vec3<T> mixed = by_twist * d.bending;
    const Vec3<T> by_normal = axpy(by_length, d.normal, axpy(by_stretch, d.shear, mixed));
    const Vec3<T> alike = d.cosine * axpy(load.torsion_moment, d.normal, load.bending_moment);
    const Vec3<T> unlike = T(0.5) * cross(d.normal, mixed);
    BondEffect<T> effect;
    effect.force = axpy(load.normal_force, d.normal, load.shear_force);
    const Vec3<T> at_reach = axpy(-d.closeness, by_normal, effect.force);
    effect.torque_i = (alike + cross(d.reach_i, at_reach)) + unlike;
    effect.torque_j = (alike - cross(d.reach_j, at_reach)) - unlike;
    return effect;
}

/// All of it for one pair: B.2, (E3), (11') (12').
template <class T>
DEM_FN BondEffect<T> bondEffect(const BondConstants<T>& bond, const PairMotion<T>& pair) {
    const BondDeformation<T> d = bondDeformation(bond.rest, pair);
    const BondLoad<T> elastic = bondLoad(bond.stiffness, d);
    const BondEffect<T> springs = elasticEffect(bond.stiffness, elastic, d);
    BondEffect<T> effect = loadEffect(damperLoad(bond.stiffness, d, bondRates(d, pair), bond.beta_r), d);
    effect.force = springs.force + effect.force;
    effect.torque_i = springs.torque_i + effect.torque_i;
    effect.torque_j = springs.torque_j + effect.torque_j;
    effect.severity = bondSeverity(elastic, bond.radius);
    effect.limit = severityLimit(bond.strength, bond.radius);
    return effect;
}

/// The damper's share of force and torques, for the ledger.
template <class T>
DEM_FN BondEffect<T> bondDamping(const BondConstants<T>& bond, const PairMotion<T>& pair) {
    const BondDeformation<T> d = bondDeformation(bond.rest, pair);
    return loadEffect(damperLoad(bond.stiffness, d, bondRates(d, pair), bond.beta_r), d);
}

/// What leaves with a bond that breaks in this substep, seen from i.
template <class T>
struct BondRelease {
    T energy{};      ///< J, of both ends together
    Wrench<T> load;  ///< on i
};

/// The bond still pulls through this kick: of the energy that it has now, what the second half of the kick
/// does with the load goes to the particles, and the rest is fracture. What the compressed faces keep stays
/// out of both (A.6).
template <class T>
DEM_FN BondRelease<T> bondRelease(const BondConstants<T>& bond, const PairMotion<T>& pair) {
    const BondDeformation<T> d = bondDeformation(bond.rest, pair);
    const BondEffect<T> pull = elasticEffect(bond.stiffness, bondLoad(bond.stiffness, d), d);
    const T squared = length2(pair.separation), inverse = inverseSqrt(squared);
    const T overlap = brokenOverlap(length(bond.rest), squared * inverse);
    const T kept = brokenRepulsion(bond.stiffness.normal, overlap);
    return {fractureEnergy(bondEnergy(bond.stiffness, d), bond.stiffness.normal, overlap),
            {axpy(kept * inverse, pair.separation, pull.force), pull.torque_i}};
}

}  // namespace demolish
