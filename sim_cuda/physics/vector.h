// SPDX-License-Identifier: Apache-2.0
// Three-component vectors of the laws; every operation is odd in each argument, to the last bit.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

template <class T>
struct Vec3 {
    T x{}, y{}, z{};
};

template <class T>
DEM_FN Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
DEM_FN Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
DEM_FN Vec3<T> operator-(const Vec3<T>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class T>
DEM_FN Vec3<T> operator*(T s, const Vec3<T>& a) {
    return {s * a.x, s * a.y, s * a.z};
}

/// s a + b, fused.
template <class T>
DEM_FN Vec3<T> axpy(T s, const Vec3<T>& a, const Vec3<T>& b) {
    return {madd(s, a.x, b.x), madd(s, a.y, b.y), madd(s, a.z, b.z)};
}

/// a . b; dot(a, b) == dot(b, a) bit for bit.
template <class T>
DEM_FN T dot(const Vec3<T>& a, const Vec3<T>& b) {
    return madd(a.x, b.x, madd(a.y, b.y, a.z * b.z));
}

/// a x b, fused. Negating one argument negates it exactly; exchanging the two does not: see crossExact.
template <class T>
DEM_FN Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
    return {madd(a.y, b.z, -(a.z * b.y)), madd(a.z, b.x, -(a.x * b.z)), madd(a.x, b.y, -(a.y * b.x))};
}

/// a x b without fusing: crossExact(b, a) == -crossExact(a, b) bit for bit.
template <class T>
DEM_FN Vec3<T> crossExact(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
DEM_FN T length2(const Vec3<T>& a) {
    return dot(a, a);
}
template <class T>
DEM_FN T length(const Vec3<T>& a) {
    return squareRoot(length2(a));
}
/// a / |a|; null for the null vector.
template <class T>
DEM_FN Vec3<T> normalized(const Vec3<T>& a) {
    return inverseSqrt(length2(a)) * a;
}

}  // namespace demolish
