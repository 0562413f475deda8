// SPDX-License-Identifier: Apache-2.0
// What a slot keeps of its contact from step to step, in one load: its tangential spring, how soft the
// contact has once been, and how deep it was when it was found.
#pragma once
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// Four zeros while nothing touches. x y z: m, the tangential spring seen from the row's particle, and along
/// the line of centres the overlap that bears no load. |w|: N/m, the least stiffness that a contact step, or
/// a rigid fragment at one end, has given the contact, or kNeverSoftened; its sign: - with such an overlap.
inline constexpr double kNeverSoftened = 1e-30;

/// A touch as it is kept.
template <class Real>
struct KeptTouch {
    Vec3<Real> spring;  ///< m
    Real softest{};     ///< N/m; 0: it has never been softened
    /// m, an overlap that the two came to before anybody saw them touch: no contact has taken in the energy
    /// that it would hold, and so it holds none. It shrinks with the overlap.
    Real unloaded{};
};

/// `normal`: unit, of the moment for which it is kept.
template <class Real>
DEM_FN Vec4<Real> packed(const KeptTouch<Real>& touch, const Vec3<Real>& normal) {
    const Real size = touch.softest > Real(0) ? touch.softest : Real(kNeverSoftened);
    if (!(touch.unloaded > Real(0))) return withW(touch.spring, size);
    return withW(axpy(touch.unloaded, normal, touch.spring), -size);
}
template <class Real>
DEM_FN Real softestOf(const Vec4<Real>& kept) {
    const Real size = absOf(kept.w);
    return size > Real(kNeverSoftened) ? size : Real(0);
}
/// `normal`: unit, likewise of the moment for which it has been kept.
template <class Real>
DEM_FN KeptTouch<Real> touchOf(const Vec4<Real>& kept, const Vec3<Real>& normal) {
    if (!(kept.w < Real(0))) return {xyz(kept), softestOf(kept), Real(0)};
    const Real along = dot(xyz(kept), normal);
    return {axpy(-along, normal, xyz(kept)), softestOf(kept), maxOf(along, Real(0))};
}
/// Against a collider nothing is ever found unseen: there the sign tells a touch that began as a hard
/// landing.
template <class Real>
DEM_FN Vec4<Real> markedHard(Vec4<Real> kept, bool is_hard) {
    if (is_hard) kept.w = -kept.w;
    return kept;
}
template <class Real>
DEM_FN bool isHardLanding(const Vec4<Real>& kept) {
    return kept.w < Real(0);
}
template <class Real>
DEM_FN bool hasBeenSofter(const Vec4<Real>& kept) {
    return softestOf(kept) > Real(0);
}
/// Whoever has parted keeps nothing: no touch begins with what another has left.
template <class Real>
DEM_FN bool holdsNothing(const Vec4<Real>& kept) {
    return !(absOf(kept.w) > Real(0));
}

}  // namespace demolish
