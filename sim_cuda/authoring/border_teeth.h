// SPDX-License-Identifier: Apache-2.0
// How much area of faces a border of tough cells costs to open.
#pragma once
#include <vector>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/authoring/tough_field.h"

namespace demolish {

/// Area of the faces between tough cells over that of the borders which they stand for: 1 where all lie in
/// them, 1.5 in an isotropic packing that knows no borders (geometry 5). `cell`: of each particle. 1 without
/// borders.
double borderTeeth(const ToughField& tough, const std::vector<BondGeometry>& bonds,
                   const std::vector<uint32_t>& cell, double spacing);

}  // namespace demolish
