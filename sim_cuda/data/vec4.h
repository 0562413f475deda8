// SPDX-License-Identifier: Apache-2.0
// Four numbers that travel as one load: the unit in which particle and bond arrays are laid out.
#pragma once
#include "sim_cuda/physics/quaternion.h"

namespace demolish {

template <class Real>
struct alignas(4 * sizeof(Real)) Vec4 {
    Real x{}, y{}, z{}, w{};
};

template <class Real>
DEM_FN Vec3<Real> xyz(const Vec4<Real>& a) {
    return {a.x, a.y, a.z};
}
template <class Real>
DEM_FN Vec4<Real> withW(const Vec3<Real>& a, Real w) {
    return {a.x, a.y, a.z, w};
}
template <class Real>
DEM_FN Quat<Real> asQuat(const Vec4<Real>& a) {
    return {a.x, a.y, a.z, a.w};
}
template <class Real>
DEM_FN Vec4<Real> asVec4(const Quat<Real>& q) {
    return {q.x, q.y, q.z, q.w};
}

}  // namespace demolish
