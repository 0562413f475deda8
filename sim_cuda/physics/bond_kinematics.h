// SPDX-License-Identifier: Apache-2.0
// What two bonded particles have done to their bond: total formulation of physics B.2, no accumulated state,
// hence no drift. Written so that exchanging i and j negates every vector exactly: each particle may evaluate
// its bonds as "i".
#pragma once
#include "sim_cuda/physics/quaternion.h"

namespace demolish {

/// Position, orientation, velocity, spin of one particle; SI, world frame.
template <class T>
struct ParticleState {
    Vec3<T> position;  ///< m
    Quat<T> rotation;  ///< 1 at rest
    Vec3<T> velocity;  ///< m/s
    Vec3<T> spin;      ///< rad/s
};

/// Rest geometry of a bond seen from i: L0 = l_i + l_j. Seen from j: -normal, lengths exchanged.
template <class T>
struct BondRest {
    Vec3<T> normal;  ///< unit, (x_j - x_i)/L0 at rest
    T length_i{};    ///< m, from i to the common point; L0/2 for a shared face
    T length_j{};    ///< m
};

/// j relative to i; stretch > 0 in tension.
template <class T>
struct BondDeformation {
    Vec3<T> normal;   ///< n, unit, from i to j
    Vec3<T> arm_i;    ///< m, P_i: the common point seen from i
    Vec3<T> arm_j;    ///< m, P_j: the same point seen from j
    T stretch{};      ///< m, u_N
    Vec3<T> shear;    ///< m, u_T
    T twist{};        ///< rad, theta_N, right-handed about n
    Vec3<T> bending;  ///< rad, theta_T
};

/// Rates of the four channels: the damper's input.
template <class T>
struct BondRates {
    Vec3<T> velocity;  ///< m/s, of j's material point minus i's at the common point
    Vec3<T> spin;      ///< rad/s, w_j - w_i
};

/// B.2. theta = 2 vec(dq): within 0.1 % of the angle up to 0.15 rad, far beyond the break of a brittle bond.
/// `separation` = x_j - x_i, given by the caller, who may hold positions in more exact form.
template <class T>
DEM_FN BondDeformation<T> bondDeformation(const BondRest<T>& rest, const Vec3<T>& separation,
                                          const Quat<T>& q_i, const Quat<T>& q_j) {
    const Vec3<T> n_i = rotate(q_i, rest.normal), n_j = rotate(q_j, rest.normal);
    const Vec3<T> reach_i = rest.length_i * n_i, reach_j = rest.length_j * n_j;
    const Vec3<T> u = separation - (reach_i + reach_j);
    const Quat<T> dq = relativeRotation(q_i, q_j);
    const T sign = dq.w < T(0) ? T(-2) : T(2);
    const Vec3<T> theta = sign * vectorPart(dq);
    BondDeformation<T> d;
    d.normal = normalized(n_i + n_j);
    d.arm_i = axpy(T(0.5), u, reach_i);
    d.arm_j = -axpy(T(0.5), u, reach_j);
    d.stretch = dot(u, d.normal);
    d.shear = axpy(-d.stretch, d.normal, u);
    d.twist = dot(theta, d.normal);
    d.bending = axpy(-d.twist, d.normal, theta);
    return d;
}

/// B.4: zero for any rigid motion of the pair.
template <class T>
DEM_FN BondRates<T> bondRates(const BondDeformation<T>& d, const Vec3<T>& v_i, const Vec3<T>& w_i,
                              const Vec3<T>& v_j, const Vec3<T>& w_j) {
    return {(v_j + cross(w_j, d.arm_j)) - (v_i + cross(w_i, d.arm_i)), w_j - w_i};
}

}  // namespace demolish
