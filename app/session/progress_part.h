// SPDX-License-Identifier: Apache-2.0
// A stage's own bar as a part of the whole one.
#pragma once
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Maps a stage's own 0..1 into its share of the whole bar. `progress` must outlive what is given back.
inline ProgressCallback part(const ProgressCallback& progress, double from, double to) {
    if (!progress) return {};
    return [&progress, from, to](double fraction, const char* stage) {
        return progress(from + (to - from) * fraction, stage);
    };
}

}  // namespace demolish
