// SPDX-License-Identifier: Apache-2.0
// Where a shot will hit a body that is still being made.
#pragma once
#include <vector>

#include "sim_cuda/api/authoring.h"

namespace demolish {

/// m, of `places` inside the body, at least one, the first that something meets which comes as `aim` says; of
/// those within `reach` m of its line, or where none is so near the one nearest to the line.
Double3 struckPlace(const ShotAim& aim, const std::vector<Double3>& places, double reach);

}  // namespace demolish
