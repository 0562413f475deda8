// SPDX-License-Identifier: Apache-2.0
// Where something stands in a row that ascends, as rows of bonds and of contacts do.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

/// The first slot in first .. end-1 whose valueAt(slot) is not below `value`; `end` when all are.
template <class Value, class ValueAt>
DEM_FN uint32_t firstNotBelow(uint32_t first, uint32_t end, Value value, const ValueAt& valueAt) {
    uint32_t low = first, high = end;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (valueAt(middle) < value)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/// The slot in first .. end-1 whose idAt(slot) is `id`; `end` when none is.
template <class IdAt>
DEM_FN uint32_t slotOfId(uint32_t first, uint32_t end, uint32_t id, const IdAt& idAt) {
    const uint32_t slot = firstNotBelow(first, end, id, idAt);
    return slot < end && idAt(slot) == id ? slot : end;
}

}  // namespace demolish
