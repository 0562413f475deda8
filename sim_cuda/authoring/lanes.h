// SPDX-License-Identifier: Apache-2.0
// Four numbers at once.
#pragma once
#include <cstdint>

namespace demolish {

using Lanes = double __attribute__((vector_size(32)));
using LaneMask = int64_t __attribute__((vector_size(32)));
inline constexpr int kLanes = 4;

inline Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}

inline Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}

}  // namespace demolish
