// SPDX-License-Identifier: Apache-2.0
// Which steps of an iteration have moved anything: after one that has not, no later one would.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/backend/span.h"

namespace demolish {

/// Of an iteration between two copies of the points: a step that moves nothing leaves both alike.
struct StepsThatMoved {
    Span<uint32_t> moved;  ///< per step: 0 before
    uint32_t step = 0;     ///< counts from 0

    DEM_FN bool isOver() const { return step > 0 && moved[step - 1] == 0; }
    DEM_FN void note() const { raise(moved[step]); }
};

}  // namespace demolish
