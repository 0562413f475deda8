// SPDX-License-Identifier: Apache-2.0
// The solid bond at work: constants (E1), forces and moments (5)-(6), (9)-(10), damper (E3), severity and
// break (11)-(12), energy. What a substep does with them: bond_effect.h.
#pragma once
#include "sim_cuda/physics/bond_kinematics.h"

namespace demolish {

/// The four constants of a bond.
template <class T>
struct BondStiffness {
    T normal{};   ///< N/m, k_N
    T shear{};    ///< N/m, k_T
    T bending{};  ///< N m/rad, k_B
    T torsion{};  ///< N m/rad, k_P
};

/// (E1), and (6') (9') (10') from (5'): k_T = a k_N, k_B = k_N a_b^2/4, k_P = 2 a k_B. `normal` in N/m,
/// `radius` a_b in m; `shear_ratio` a is chosen (E1), or follows from nu (paperShearRatio).
template <class T>
DEM_FN BondStiffness<T> roundBond(T normal, T shear_ratio, T radius) {
    const T bending = normal * (T(0.25) * radius * radius);
    return {normal, shear_ratio * normal, bending, T(2) * shear_ratio * bending};
}

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

/// (E3): every channel's damper gives beta_R (s) times its stiffness times its rate, beside the springs. For
/// forces only, never for the break test.
template <class T>
DEM_FN BondLoad<T> damperLoad(const BondStiffness<T>& k, const BondDeformation<T>& d,
                              const BondRates<T>& rates, T beta_r) {
    const T speed = dot(rates.velocity, d.normal), twist = dot(rates.spin, d.normal);
    const Vec3<T> slip = axpy(-speed, d.normal, rates.velocity), bend = axpy(-twist, d.normal, rates.spin);
    return {beta_r * k.normal * speed, (beta_r * k.shear) * slip, beta_r * k.torsion * twist,
            (beta_r * k.bending) * bend};
}

/// (11') sigma = N_b/A + 4 |M_T|/(A a_b), the stress of a round beam, times pi a_b^3 = A a_b: N m, without a
/// division. Negative under strong compression: no bending-only failure there. ELASTIC load; radius a_b in m.
template <class T>
DEM_FN T tensileSeverity(const BondLoad<T>& load, T radius) {
    return madd(load.normal_force, radius, T(4) * length(load.bending_moment));
}
/// (12') tau = |T_b|/A + 2 |M_N|/(A a_b), likewise.
template <class T>
DEM_FN T shearSeverity(const BondLoad<T>& load, T radius) {
    return madd(length(load.shear_force), radius, T(2) * absOf(load.torsion_moment));
}
/// The larger one: both strengths are equal by (13).
template <class T>
DEM_FN T bondSeverity(const BondLoad<T>& load, T radius) {
    return maxOf(tensileSeverity(load, radius), shearSeverity(load, radius));
}
/// N m: the right side of (11') and (12') times pi a_b^3. `strength` s_b sigma_c in Pa, radius a_b in m.
template <class T>
DEM_FN T severityLimit(T strength, T radius) {
    return T(kPi) * strength * (radius * radius * radius);
}
/// (11') or (12') reached.
template <class T>
DEM_FN bool bondBreaks(T severity, T limit) {
    return severity >= limit;
}

/// Elastic energy, J: half of stiffness times square in each channel (A.3). Since theta = 2 sin(angle/2)
/// (bondDeformation), turning takes in 1 - cos(angle) times the stiffness, which is smooth all the way round.
/// What a folded bond's short n leaves of u and theta counts as shear and bending.
template <class T>
DEM_FN T bondEnergy(const BondStiffness<T>& k, const BondDeformation<T>& d) {
    const T stretch2 = d.stretch * d.stretch, twist2 = d.twist * d.twist;
    const T left = d.folded ? T(1) - length2(d.normal) : T(0);
    const T shear2 = length2(d.shear) + left * stretch2, bending2 = length2(d.bending) + left * twist2;
    return T(0.5) * (k.normal * stretch2 + k.shear * shear2 + k.torsion * twist2 + k.bending * bending2);
}

}  // namespace demolish
