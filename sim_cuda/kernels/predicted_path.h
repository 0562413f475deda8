// SPDX-License-Identifier: Apache-2.0
// How long contact lists stay valid. A pair is listed when its two straight paths from the build on,
// x + v t for 0 <= t <= horizon, come closer than R_c,i + skin_i + R_c,j + skin_j. As long as the horizon is
// not over and no particle is farther than its skin from its path, a pair that is not listed cannot touch:
// |x_j - x_i| >= |path_j - path_i| - skin_i - skin_j >= R_c,i + R_c,j. Fragments that fly apart, however
// fast, stay on their paths and cost nothing.
//
// A particle that uses up half its skin gets a new path if few do (strayed_paths.h), else lists are built
// again; the other half is for what happens between two looks and for round-off.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/data/particles.h"

namespace demolish {

/// Share of the skin that a particle may use up before the lists are built again.
inline constexpr double kTrustedSkin = 0.5;

/// Will the two meet (closer than the sum of their reaches) on straight paths within the horizon (s)? Each is
/// given as in PathsIn. Exchanging them changes no bit of the answer.
template <class Real>
DEM_FN bool mayMeet(const Vec4<Real>& x_i, const Vec4<Real>& v_i, const Vec4<Real>& x_j,
                    const Vec4<Real>& v_j, Real horizon) {
    const Vec3<Real> x = xyz(x_j) - xyz(x_i), v = xyz(v_j) - xyz(v_i);
    const Real reach = reachOf(x_i) + reachOf(x_j), near2 = reach * reach;
    if (length2(x) < near2) return true;
    const Real closing = -dot(x, v), speed2 = length2(v);
    if (!(closing > Real(0))) return false;
    const Real nearest = closing / speed2;
    return length2(axpy(nearest < horizon ? nearest : horizon, v, x)) < near2;
}

/// True when a particle has strayed from its path by more than the trusted part of its skin, or will within
/// `lookahead` (s, until the next look) at its present velocity. `elapsed` s since the build.
template <class Real>
DEM_FN bool leavesPath(const Vec4<Real>& built_position, const Vec4<Real>& built_velocity,
                       const Vec3<Real>& position, const Vec3<Real>& velocity, Real elapsed, Real lookahead) {
    const Vec3<Real> turned = velocity - xyz(built_velocity);
    const Vec3<Real> strayed = axpy(-elapsed, xyz(built_velocity), position - xyz(built_position));
    const Real trusted = Real(kTrustedSkin) * skinOf(built_velocity);
    return trusted >= Real(0) && !(length2(axpy(lookahead, turned, strayed)) <= trusted * trusted);
}

}  // namespace demolish
