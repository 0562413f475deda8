// SPDX-License-Identifier: Apache-2.0
// Arithmetic on Double3 for the host geometry of this room (the solver's float vectors live in physics).
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/vectors.h"

namespace demolish {

inline Double3 operator+(const Double3& a, const Double3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Double3 operator-(const Double3& a, const Double3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Double3 operator-(const Double3& a) {
    return {-a.x, -a.y, -a.z};
}
inline Double3 operator*(const Double3& a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Double3 operator*(double s, const Double3& a) {
    return a * s;
}
inline Double3& operator+=(Double3& a, const Double3& b) {
    return a = a + b;
}
inline double dot(const Double3& a, const Double3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Double3 cross(const Double3& a, const Double3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double lengthSquared(const Double3& a) {
    return dot(a, a);
}
inline double length(const Double3& a) {
    return std::sqrt(dot(a, a));
}
/// Zero stays zero.
inline Double3 normalized(const Double3& a) {
    const double l = length(a);
    return l > 0 ? a * (1 / l) : Double3{};
}
inline Double3 minimum(const Double3& a, const Double3& b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Double3 maximum(const Double3& a, const Double3& b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace demolish
