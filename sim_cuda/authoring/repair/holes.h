// SPDX-License-Identifier: Apache-2.0
// Caps over what is open.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct HoleCounts {
    size_t holes = 0;    ///< loops that were capped
    size_t fans = 0;     ///< of them by a vertex in the middle, being too long for the least area
    size_t longest = 0;  ///< edges
    void add(size_t edges) {
        ++holes;
        longest = longest < edges ? edges : longest;
    }
};

/// A closed chain of vertices, each once, in the direction of the cap.
struct Border {
    uint32_t part = 0;
    std::vector<uint32_t> loop;
};

/// From the imbalance of directed edges within each part. In equals out at every vertex, so that the chains
/// always close, however faces meet there.
std::vector<Border> borderLoops(const RepairMesh& repair);

/// Closes every part: caps of the least area by dynamic programming up to some hundred edges, beyond them a
/// fan. Caps have kNoSource and lie behind the other triangles. Returns counts by part.
std::vector<HoleCounts> fillHoles(RepairMesh& repair);

}  // namespace demolish
