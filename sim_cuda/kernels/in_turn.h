// SPDX-License-Identifier: Apache-2.0
// Two kernels that every thread can do one after the other, as one.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

/// Two calls for the same item, one after the other: the second reads what the first writes for this item,
/// and nothing that it writes for others.
template <class First, class Second>
struct InTurn {
    First first;
    Second second;

    DEM_FN void operator()(uint32_t i) const {
        first(i);
        second(i);
    }
};

}  // namespace demolish
