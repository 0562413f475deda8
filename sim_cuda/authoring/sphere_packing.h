// SPDX-License-Identifier: Apache-2.0
// Hard spheres pushed apart inside a round container.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// Centres (m) of spheres of these radii (m) inside a ball of `container` m about the origin, from random
/// places by descent on the overlap energy. What overlap is left is below 2 % of two radii up to a solid
/// fraction of 0.62.
std::vector<Double3> packSpheres(const std::vector<double>& radii, double container, uint64_t seed);

}  // namespace demolish
