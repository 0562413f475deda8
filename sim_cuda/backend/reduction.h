// SPDX-License-Identifier: Apache-2.0
// The one order in which both devices add up an array, so that a sum has the same bits everywhere: chunks of
// 256 neighbours, each folded as a tree; the chunks' results are folded the same way until one is left.
#pragma once
#include <cstddef>

#include "sim_cuda/physics/function.h"

namespace demolish {

inline constexpr size_t kReductionChunk = 256;

/// Sums as they stand in the chunk; T needs +=.
template <class T>
struct SumInto {
    DEM_FN void operator()(T& into, const T& other) const { into += other; }
};

}  // namespace demolish
