// SPDX-License-Identifier: Apache-2.0
// Forms of the paper that NO solver computes: for comparison alone. Each stands beside the law that runs in
// its place, and the tests compare the two. (Printed factors and signs that are corrected here are in the
// tests of the corrected laws.)
#pragma once
#include "sim_cuda/physics/bond_stiffness.h"

namespace demolish::paper {

/// (7) with interaction of bonds inside a particle, psi >= 0; the paper gives no formula for psi. Runs:
/// normalCorrection(), psi = 0. Throws std::invalid_argument where the denominator is not positive.
inline double normalCorrection(double ratio, double nu, double psi) {
    const double coupled = ratio + ratio * ratio * bondCoupling(ratio, nu);
    const double denominator = std::sqrt(1 - ratio * ratio) - psi * coupled;
    bond_detail::demand(psi >= 0, "bond interaction psi must not be negative");
    bond_detail::demand(denominator > 0, "bond interaction psi is too large for this bond radius ratio a*");
    return (1 + ratio * bondCoupling(ratio, nu)) / denominator;
}

/// Another reading of a* on a face: min(2 a_b/L, 0.9); radius and length in m. Runs: faceRatioNeck().
inline double faceRatioClamped(double radius, double length) {
    return std::fmin(2 * radius / length, 0.9);
}

/// M_T of (15) with a cap, |M_T| <= share N a_b, N m: a face without tension carries no more; share of a
/// round face 1/4. Runs: share 0, no moment.
template <class T>
DEM_FN Vec3<T> cappedBendingMoment(const Vec3<T>& moment, T share, T repulsive_force, T radius) {
    const T limit = share * repulsive_force * radius, size2 = length2(moment);
    return size2 > limit * limit ? (limit * inverseSqrt(size2)) * moment : moment;
}

/// Delta r of the clustering rule (3.2.1), m: sigma_c A/k_N, the stretch at which tension alone breaks the
/// bond. Runs: bondBreaks().
template <class T>
DEM_FN T stretchLimit(T strength, T area, T normal_stiffness) {
    return strength * area / normal_stiffness;
}
/// NORMAL while r <= r0 + Delta r, DISCRETE after; compression never breaks. Lengths in m.
template <class T>
DEM_FN bool isDiscrete(T distance, T rest_length, T limit) {
    return distance > rest_length + limit;
}
/// Share of the force left in the DISCRETE state that fades linearly to 0 at r_f > r0 + Delta r; 1 while
/// NORMAL. Runs: a broken bond never pulls.
template <class T>
DEM_FN T discreteShare(T distance, T rest_length, T limit, T fade_end) {
    return clampTo((fade_end - distance) / (fade_end - rest_length - limit), T(0), T(1));
}

}  // namespace demolish::paper
