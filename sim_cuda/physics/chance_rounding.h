// SPDX-License-Identifier: Apache-2.0
// Sums of many changes that are not much larger than the last digit of what they are added to. Rounded to the
// nearest, each of a thousand equal ones is rounded the same way, and those below half of the digit never
// count. Rounded up or down by chance they add up to what they are in the mean.
#pragma once
#include "sim_cuda/physics/random.h"

namespace demolish {

/// What the last digit of x counts; 0 of denormal x.
DEM_FN float lastDigit(float x) {
    return std::bit_cast<float>(std::bit_cast<uint32_t>(x) & 0x7f800000u) * 0x1p-23f;
}
DEM_FN double lastDigit(double x) {
    return std::bit_cast<double>(std::bit_cast<uint64_t>(x) & 0x7ff0000000000000ull) * 0x1p-52;
}

/// value + change, rounded by chance; `uniform` in (0, 1).
template <class T>
DEM_FN T addedByChance(T value, T change, T uniform) {
    if (!(absOf(change) > T(0))) return value;
    return value + madd(lastDigit(value), uniform - T(0.5), change);
}

}  // namespace demolish
