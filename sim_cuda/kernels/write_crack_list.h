// SPDX-License-Identifier: Apache-2.0
// Ids of the crack edges that show, in ascending order.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

struct WriteCrackList {
    Span<const uint32_t> place;  ///< exclusive scan of "shown"
    Span<uint32_t> out;

    DEM_FN void operator()(uint32_t k) const {
        if (place[k + 1] > place[k] && place[k] < out.size()) out[place[k]] = k;
    }
};

}  // namespace demolish
