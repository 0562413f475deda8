// Where an id stands in a row that ascends, as rows of bonds and of contacts do.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

/// The slot in first .. end-1 whose idAt(slot) is `id`; `end` when none is.
template <class IdAt>
DEM_FN uint32_t slotOfId(uint32_t first, uint32_t end, uint32_t id, const IdAt& idAt) {
    uint32_t low = first, high = end;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (idAt(middle) < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < end && idAt(low) == id ? low : end;
}

}  // namespace demolish
