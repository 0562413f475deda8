// SPDX-License-Identifier: Apache-2.0
// Which side of each part is the outside.
#pragma once
#include "sim_cuda/authoring/repair/part_facts.h"

namespace demolish {

struct OutwardCounts {
    size_t turned = 0;    ///< parts
    size_t cavities = 0;  ///< parts that stay inside out, being hollows in others
};

/// The part with the largest volume tells whether the whole file is inside out. What is negative then is a
/// cavity if it was closed, never touched, and lies inside the others; else it is turned. Keeps `facts` in
/// step.
OutwardCounts turnOutward(RepairMesh& filled, std::vector<PartFacts>& facts);

}  // namespace demolish
