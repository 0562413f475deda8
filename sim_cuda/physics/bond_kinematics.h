// SPDX-License-Identifier: Apache-2.0
// What two bonded particles have done to their bond: total formulation of physics B.2, no accumulated state,
// hence no drift. Written so that exchanging i and j negates every vector exactly: each particle may evaluate
// its bonds as "i".
#pragma once
#include "sim_cuda/physics/pair_motion.h"

namespace demolish {

/// Of the rest length: a bond is folded where its two halves, each turned with its own end, add up to less.
/// Bent by more than 120 degrees, that is; at 180 degrees they cancel, and no way from i to j is left.
inline constexpr double kFolded = 0.5;

/// j relative to i; stretch > 0 in tension.
template <class T>
struct BondDeformation {
    Vec3<T> normal;   ///< n, from i to j; unit, but shorter in a folded bond, down to nothing
    Vec3<T> reach_i;  ///< m, l_i n_i: half of the rest vector, turned with i
    Vec3<T> reach_j;  ///< m, l_j n_j: the other half, turned with j
    Vec3<T> arm_i;    ///< m, P_i: the common point seen from i
    Vec3<T> arm_j;    ///< m, P_j: the same point seen from j
    T closeness{};    ///< 1/m, of n to l_i n_i + l_j n_j: how fast n turns with the reaches' ends
    T stretch{};      ///< m, u_N
    Vec3<T> shear;    ///< m, u_T
    T twist{};        ///< rad, theta_N, right-handed about n
    Vec3<T> bending;  ///< rad, theta_T
    T cosine{};       ///< of half the angle between the two, 0 to 1
    bool folded{};    ///< kFolded: closeness grows no further
};

/// Rates of the four channels: the damper's input.
template <class T>
struct BondRates {
    Vec3<T> velocity;  ///< m/s, of j's material point minus i's at the common point
    Vec3<T> spin;      ///< rad/s, w_j - w_i
};

/// B.2. theta = 2 vec(dq): within 0.1 % of the angle up to 0.15 rad, far beyond the break of a brittle bond.
/// `rest` = x_j - x_i at rest (m): the common point lies in its middle, since the face of two cells lies on
/// their bisector. The separation is given by the caller, who may hold positions in more exact form.
template <class T>
DEM_FN BondDeformation<T> bondDeformation(const Vec3<T>& rest, const PairMotion<T>& pair) {
    BondDeformation<T> d;
    d.reach_i = T(0.5) * rotate(pair.rotation_i, rest);
    d.reach_j = T(0.5) * rotate(pair.rotation_j, rest);
    const Vec3<T> both = d.reach_i + d.reach_j, u = pair.separation - both;
    const Quat<T> dq = relativeRotation(pair.rotation_i, pair.rotation_j);
    const T sign = dq.w < T(0) ? T(-2) : T(2);
    const Vec3<T> theta = sign * vectorPart(dq);
    const T squared = length2(both), least = T(kFolded * kFolded) * length2(rest);
    d.folded = squared < least;
    d.closeness = inverseSqrt(d.folded ? least : squared);
    d.normal = d.closeness * both;
    d.arm_i = axpy(T(0.5), u, d.reach_i);
    d.arm_j = -axpy(T(0.5), u, d.reach_j);
    d.stretch = dot(u, d.normal);
    d.shear = axpy(-d.stretch, d.normal, u);
    d.twist = dot(theta, d.normal);
    d.bending = axpy(-d.twist, d.normal, theta);
    d.cosine = absOf(dq.w);
    return d;
}

/// B.4: zero for any rigid motion of the pair.
template <class T>
DEM_FN BondRates<T> bondRates(const BondDeformation<T>& d, const PairMotion<T>& pair) {
    return {(pair.velocity_j + cross(pair.spin_j, d.arm_j)) - (pair.velocity_i + cross(pair.spin_i, d.arm_i)),
            pair.spin_j - pair.spin_i};
}

}  // namespace demolish
