// SPDX-License-Identifier: Apache-2.0
// Arithmetic that gives the same bits on every compiler and device: + - * / sqrt, a fused multiply-add,
// ternaries.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

inline constexpr double kPi = 3.14159265358979323846;

/// a b + c, rounded once. Written out wherever it is wanted: compilers are told not to contract by
/// themselves.
DEM_FN float madd(float a, float b, float c) {
    return fmaf(a, b, c);
}
DEM_FN double madd(double a, double b, double c) {
    return fma(a, b, c);
}

/// Ternaries, not fminf and fmaxf: those differ between host and device for NaN and for the sign of zero.
template <class T>
DEM_FN T minOf(T a, T b) {
    return b < a ? b : a;
}
template <class T>
DEM_FN T maxOf(T a, T b) {
    return a < b ? b : a;
}
template <class T>
DEM_FN T absOf(T x) {
    return x < T(0) ? -x : x;
}
/// NaN stays NaN.
template <class T>
DEM_FN T clampTo(T x, T low, T high) {
    return x < low ? low : (high < x ? high : x);
}

/// 1 / sqrt(x), relative error at most 7.5e-8 for normal x (frame_facts 1). 0 for zero, denormal and negative
/// x, so that a null vector normalises to null; NaN for NaN and infinity, so that a blown-up state is still
/// noticed.
DEM_FN float inverseSqrt(float x) {
    float y = std::bit_cast<float>(0x5f375a86u - (std::bit_cast<uint32_t>(x) >> 1));
    const float h = 0.5f * x;
    y = fmaf(y, fmaf(-(h * y), y, 0.5f), y);
    y = fmaf(y, fmaf(-(h * y), y, 0.5f), y);
    y = fmaf(y, fmaf(-(h * y), y, 0.5f), y);
    return x < 1.17549435e-38f ? 0.0f : y;
}
DEM_FN double inverseSqrt(double x) {
    return x < 2.2250738585072014e-308 ? 0.0 : 1.0 / sqrt(x);
}

/// sqrt(x) by inverseSqrt: one multiplication where 1 / sqrt is wanted as well. 0 for x <= 0.
DEM_FN float squareRoot(float x) {
    return x * inverseSqrt(x);
}
DEM_FN double squareRoot(double x) {
    return x < 0.0 ? 0.0 : sqrt(x);
}

}  // namespace demolish
