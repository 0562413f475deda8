// SPDX-License-Identifier: Apache-2.0
// Records of pairs of different bodies, put into the rows of both. Host code in double.
#pragma once
#include <vector>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Of one pair: what either end keeps of it.
struct PairRecord {
    uint32_t i = 0, j = 0;  ///< i < j, particles of the scene
    BondSlot at_i, at_j;
};

/// Into the rows of the bodies, of which they change nothing. Bonds come after all others in their order.
void appendRecords(const std::vector<PairRecord>& records, SceneTables& tables);

}  // namespace demolish
