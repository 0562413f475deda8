// SPDX-License-Identifier: Apache-2.0
// The solid bond at work: forces and moments (5)-(6), (9)-(10), its damper (E3), stresses and break
// (11)-(12), energy.
#pragma once
#include "sim_cuda/physics/bond_kinematics.h"

namespace demolish {

/// The four constants of a bond; made by bond_stiffness.h.
template <class T>
struct BondStiffness {
    T normal{};   ///< N/m, k_N
    T shear{};    ///< N/m, k_T
    T bending{};  ///< N m/rad, k_B
    T torsion{};  ///< N m/rad, k_P
};

/// What the bond does to i; j gets the exact opposite force and moment, at its own arm.
template <class T>
struct BondLoad {
    T normal_force{};        ///< N, N_b, > 0 in tension (the paper's N_b has the other sign)
    Vec3<T> shear_force;     ///< N, T_b
    T torsion_moment{};      ///< N m, M_N
    Vec3<T> bending_moment;  ///< N m, M_T
};

/// (5') (6') (9') (10'), and (E1) with its own constants.
template <class T>
DEM_FN BondLoad<T> bondLoad(const BondStiffness<T>& k, const BondDeformation<T>& d) {
    return {k.normal * d.stretch, k.shear * d.shear, k.torsion * d.twist, k.bending * d.bending};
}

/// (E3): every channel gets beta_R (s) times its stiffness times its rate on top. For forces only, never for
/// the break test.
template <class T>
DEM_FN BondLoad<T> dampedBondLoad(const BondLoad<T>& elastic, const BondStiffness<T>& k,
                                  const BondDeformation<T>& d, const BondRates<T>& rates, T beta_r) {
    const T speed = dot(rates.velocity, d.normal), twist = dot(rates.spin, d.normal);
    const Vec3<T> slip = axpy(-speed, d.normal, rates.velocity), bend = axpy(-twist, d.normal, rates.spin);
    return {madd(beta_r * k.normal, speed, elastic.normal_force),
            axpy(beta_r * k.shear, slip, elastic.shear_force),
            madd(beta_r * k.torsion, twist, elastic.torsion_moment),
            axpy(beta_r * k.bending, bend, elastic.bending_moment)};
}

/// Power that the damper takes out, W, >= 0: (damped - elastic) load against the rates.
template <class T>
DEM_FN T bondDampingPower(const BondStiffness<T>& k, const BondDeformation<T>& d, const BondRates<T>& rates,
                          T beta_r) {
    const T speed = dot(rates.velocity, d.normal), twist = dot(rates.spin, d.normal);
    const Vec3<T> slip = axpy(-speed, d.normal, rates.velocity), bend = axpy(-twist, d.normal, rates.spin);
    return beta_r * (k.normal * speed * speed + k.shear * length2(slip) + k.torsion * twist * twist +
                     k.bending * length2(bend));
}

/// Force on i (N) and torque on i about its centre (N m): F = N n + T, tau_i = P_i x F + M_N n + M_T (B.2).
template <class T>
struct Wrench {
    Vec3<T> force;
    Vec3<T> torque;
};
template <class T>
DEM_FN Wrench<T> bondWrench(const BondLoad<T>& load, const BondDeformation<T>& d) {
    const Vec3<T> force = axpy(load.normal_force, d.normal, load.shear_force);
    const Vec3<T> moment = axpy(load.torsion_moment, d.normal, load.bending_moment);
    return {force, moment + cross(d.arm_i, force)};
}

/// Pa; the two ends compute the same bits.
template <class T>
struct BondStress {
    T tension{};  ///< (11') N_b/A + 4|M_T|/(A a_b); negative under strong compression: no bending-only
                  ///< failure there
    T shear{};    ///< (12') |T_b|/A + 2|M_N|/(A a_b)
};

/// (11') (12') and (E2): stresses of a round beam, pi a_b^3 = A a_b. Area in m^2, radius a_b in m; ELASTIC
/// load only.
template <class T>
DEM_FN BondStress<T> bondStress(const BondLoad<T>& load, T area, T radius) {
    const T inverse_area = T(1) / area, inverse_modulus = inverse_area / radius;
    return {
        madd(load.normal_force, inverse_area, T(4) * length(load.bending_moment) * inverse_modulus),
        madd(length(load.shear_force), inverse_area, T(2) * absOf(load.torsion_moment) * inverse_modulus)};
}

/// (11') (12') reached? Strengths in Pa (equal by (13)); mu_b >= 0 adds mu_b max(0, -N_b/A) to the shear
/// strength.
template <class T>
DEM_FN bool bondBreaks(const BondStress<T>& stress, T tensile_strength, T shear_strength) {
    return stress.tension >= tensile_strength || stress.shear >= shear_strength;
}
/// Shear strength (Pa) with the optional friction term of stone and concrete (A.4): sigma_c,s + mu_b max(0,
/// -N_b/A).
template <class T>
DEM_FN T confinedShearStrength(T shear_strength, T bond_friction, T normal_force, T area) {
    return madd(bond_friction, maxOf(-normal_force, T(0)) / area, shear_strength);
}

/// Elastic energy, J: (k_N u_N^2 + k_T u_T^2 + k_P theta_N^2 + k_B theta_T^2)/2 (A.3).
template <class T>
DEM_FN T bondEnergy(const BondStiffness<T>& k, const BondDeformation<T>& d) {
    return T(0.5) * (k.normal * d.stretch * d.stretch + k.shear * length2(d.shear) +
                     k.torsion * d.twist * d.twist + k.bending * length2(d.bending));
}

}  // namespace demolish
