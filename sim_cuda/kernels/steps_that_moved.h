// SPDX-License-Identifier: Apache-2.0
// Iterations between two copies of points: each step reads one and writes the other. And which steps have
// moved anything: after one that has not, no later one would.
#pragma once
#include "sim_cuda/api/vectors.h"
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/backend/span.h"

namespace demolish {

/// Steps count from 0; the first reads `points` and so, after an even number of them, it is that which was
/// written last.
struct TwoCopies {
    Span<Float3> points, other;

    DEM_FN Span<const Float3> before(uint32_t step) const { return step % 2 == 0 ? points : other; }
    DEM_FN Span<Float3> after(uint32_t step) const { return step % 2 == 0 ? other : points; }
};

/// A step that moves nothing leaves both copies alike.
struct StepsThatMoved {
    Span<uint32_t> moved;  ///< per step: 0 before

    DEM_FN bool isOver(uint32_t step) const { return step > 0 && moved[step - 1] == 0; }
    DEM_FN void note(uint32_t step) const { raise(moved[step]); }
};

}  // namespace demolish
