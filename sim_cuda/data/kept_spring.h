// SPDX-License-Identifier: Apache-2.0
// What a slot keeps of its contact from step to step, in one load: its tangential spring, and how soft the
// contact has once been.
#pragma once
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// spring: m, seen from the row's particle; null when not touching. softest: N/m, the least stiffness that a
/// contact step, or a rigid fragment at one end, has given the contact; 0: neither has.
template <class Real>
DEM_FN Vec4<Real> keptSpring(const Vec3<Real>& spring, Real softest) {
    return withW(spring, softest);
}
template <class Real>
DEM_FN Real softestOf(const Vec4<Real>& kept) {
    return kept.w;
}
template <class Real>
DEM_FN bool hasBeenSofter(const Vec4<Real>& kept) {
    return kept.w > Real(0);
}
/// Whoever has parted keeps nothing: no touch begins with what another has left.
template <class Real>
DEM_FN bool holdsNothing(const Vec4<Real>& kept) {
    return !(length2(xyz(kept)) > Real(0)) && !hasBeenSofter(kept);
}

}  // namespace demolish
