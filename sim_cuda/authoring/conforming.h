// SPDX-License-Identifier: Apache-2.0
// Moves the seeds of a packing so that cells follow the borders of tough cells (geometry 1.1).
#pragma once
#include <functional>
#include <vector>

#include "sim_cuda/authoring/border_feet.h"

namespace demolish {

/// Seeds in pairs, mirrored at a border: the face between the two of a pair lies in it. The others keep clear
/// of what the pairs hold. `tell` after every round; the same for any number of threads.
void conformSeeds(const ToughBorders& borders, uint64_t random, std::vector<Double3>& seeds,
                  const std::function<void(double fraction)>& tell);

}  // namespace demolish
