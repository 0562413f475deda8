// SPDX-License-Identifier: Apache-2.0
// Plain contact of two spheres, or of a sphere and a rigid wall: (1)-(4) of the paper as corrected in physics
// A.2. Overlap delta > 0 and force > 0 mean compression. SI units; any consistent set works.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// Effective moduli of a contact, Pa.
template <class T>
struct ContactModuli {
    T normal{};      ///< E*
    T tangential{};  ///< G*
};

/// 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2, 1/G* = (2-nu1)/G1 + (2-nu2)/G2, G = E/(2(1+nu)); E > 0 Pa, 0 <= nu <
/// 0.5.
template <class T>
DEM_FN ContactModuli<T> contactModuli(T E1, T nu1, T E2, T nu2) {
    const T g1 = T(2) * (T(1) + nu1) * (T(2) - nu1) / E1;
    const T g2 = T(2) * (T(1) + nu2) * (T(2) - nu2) / E2;
    return {T(1) / ((T(1) - nu1 * nu1) / E1 + (T(1) - nu2 * nu2) / E2), T(1) / (g1 + g2)};
}
/// A rigid wall: E* = E/(1-nu^2), G* = G/(2-nu); twice the values of two equal bodies.
template <class T>
DEM_FN ContactModuli<T> rigidWallModuli(T E, T nu) {
    return {E / (T(1) - nu * nu), E / (T(2) * (T(1) + nu) * (T(2) - nu))};
}

/// R* = R1 R2/(R1+R2), m; a wall has R* = R1. By our own reciprocal.
template <class T>
DEM_FN T reduced(T a, T b) {
    const T root = inverseSqrt(a + b);
    return (a * b) * (root * root);
}

/// (1') contact radius a = sqrt(R* delta), m; 0 without overlap.
template <class T>
DEM_FN T contactRadius(T R, T delta) {
    return delta > T(0) ? squareRoot(R * delta) : T(0);
}
/// (1') F_H = (4/3) E* a^3/R* = (4/3) E* a delta, N, with a = contactRadius.
template <class T>
DEM_FN T hertzForce(T E, T a, T delta) {
    return T(4.0 / 3) * E * a * maxOf(delta, T(0));
}
/// (2') k_t = 8 G* a, N/m.
template <class T>
DEM_FN T mindlinStiffness(T G, T a) {
    return T(8) * G * a;
}

/// (3') DMT adhesion 2 pi w R*, N (>= 0, to be subtracted); w in J/m^2. Ramped over delta in [0, 0.01 R*] so
/// that the force does not jump when two particles touch; 0 without overlap.
template <class T>
DEM_FN T adhesionForce(T w, T R, T delta) {
    const T full = T(2 * kPi) * w * R;
    return full * clampTo(T(100) * delta / R, T(0), T(1));
}

/// Damper of the Hertz law, N s/m: alpha sqrt(m_e K_h) delta^(1/4), K_h = (4/3) E* sqrt(R*). With a = sqrt(R*
/// delta) K_h sqrt(delta) = (4/3) E* a.
template <class T>
DEM_FN T hertzDamping(T alpha, T E, T reduced_mass, T a) {
    return alpha * squareRoot(reduced_mass * (T(4.0 / 3) * E * a));
}
/// Damper of the linear law, N s/m: c^ sqrt(k m_e).
template <class T>
DEM_FN T linearDamping(T c, T stiffness, T reduced_mass) {
    return c * squareRoot(stiffness * reduced_mass);
}

/// Elastic force and damper on the approach speed v_n (m/s, > 0 while approaching), clamped: a contact never
/// pulls.
template <class T>
DEM_FN T repulsion(T elastic, T damping, T approach_speed) {
    return maxOf(madd(damping, approach_speed, elastic), T(0));
}

}  // namespace demolish
