// SPDX-License-Identifier: Apache-2.0
// Unit quaternions for particle orientations: rotation, relative rotation, one step of spinning (physics B.1,
// B.2).
#pragma once
#include "sim_cuda/physics/vector.h"

namespace demolish {

/// x y z w; rotates by q v q*. The unit quaternion (0 0 0 1) is the rest orientation.
template <class T>
struct Quat {
    T x{}, y{}, z{}, w{1};
};

template <class T>
DEM_FN Vec3<T> vectorPart(const Quat<T>& q) {
    return {q.x, q.y, q.z};
}

/// q v q* for unit q; odd in v to the last bit.
template <class T>
DEM_FN Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
    const Vec3<T> axis = vectorPart(q);
    const Vec3<T> t = T(2) * cross(axis, v);
    return axpy(q.w, t, v + cross(axis, t));
}

template <class T>
DEM_FN Quat<T> conjugate(const Quat<T>& q) {
    return {-q.x, -q.y, -q.z, q.w};
}

/// a b (first b, then a).
template <class T>
DEM_FN Quat<T> multiply(const Quat<T>& a, const Quat<T>& b) {
    const Vec3<T> av = vectorPart(a), bv = vectorPart(b);
    const Vec3<T> v = axpy(a.w, bv, axpy(b.w, av, cross(av, bv)));
    return {v.x, v.y, v.z, madd(a.w, b.w, -dot(av, bv))};
}

/// b conj(a): the rotation from a to b. Exchanging a and b negates the vector part exactly and leaves w,
/// hence the grouping and the unfused products.
template <class T>
DEM_FN Quat<T> relativeRotation(const Quat<T>& a, const Quat<T>& b) {
    const Vec3<T> av = vectorPart(a), bv = vectorPart(b);
    const Vec3<T> v = (a.w * bv - b.w * av) - crossExact(bv, av);
    return {v.x, v.y, v.z, a.w * b.w + dot(av, bv)};
}

template <class T>
DEM_FN Quat<T> normalized(const Quat<T>& q) {
    const T s = inverseSqrt(madd(q.x, q.x, madd(q.y, q.y, madd(q.z, q.z, q.w * q.w))));
    return {s * q.x, s * q.y, s * q.z, s * q.w};
}

/// exp(h): h = half the rotation vector, rad. Series of sin|h|/|h| and cos|h|: exact to round-off for |h| <=
/// 0.5 in float and in double; a substep turns by far less. Not normalised.
template <class T>
DEM_FN Quat<T> exponential(const Vec3<T>& h) {
    const T s = length2(h);
    T sine, cosine;
    if constexpr (sizeof(T) == sizeof(float)) {
        sine = madd(s, madd(s, madd(s, T(-1.0 / 5040), T(1.0 / 120)), T(-1.0 / 6)), T(1));
        cosine =
            madd(s, madd(s, madd(s, madd(s, T(1.0 / 40320), T(-1.0 / 720)), T(1.0 / 24)), T(-0.5)), T(1));
    } else {
        sine = madd(s, T(1.0 / 6227020800), T(-1.0 / 39916800));
        sine = madd(s, madd(s, sine, T(1.0 / 362880)), T(-1.0 / 5040));
        sine = madd(s, madd(s, madd(s, sine, T(1.0 / 120)), T(-1.0 / 6)), T(1));
        cosine = madd(s, madd(s, T(-1.0 / 87178291200), T(1.0 / 479001600)), T(-1.0 / 3628800));
        cosine = madd(s, madd(s, cosine, T(1.0 / 40320)), T(-1.0 / 720));
        cosine = madd(s, madd(s, madd(s, cosine, T(1.0 / 24)), T(-0.5)), T(1));
    }
    const Vec3<T> v = sine * h;
    return {v.x, v.y, v.z, cosine};
}

/// Orientation after dt (s) at the world-frame spin w (rad/s): normalised exp(dt w / 2) q (physics B.1).
template <class T>
DEM_FN Quat<T> advanced(const Quat<T>& q, const Vec3<T>& w, T dt) {
    return normalized(multiply(exponential((T(0.5) * dt) * w), q));
}

}  // namespace demolish
