// SPDX-License-Identifier: Apache-2.0
// Edges by sorting their uses.
#include "sim_cuda/authoring/repair/edge_uses.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace demolish {

std::vector<EdgeUse> edgeUses(const TriangleMesh& mesh, const std::vector<uint32_t>& group) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * mesh.triangles.size());
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
            uses.push_back({group.empty() ? 0 : group[t], std::min(from, to), std::max(from, to), t,
                            from < to ? 1 : -1});
        }
    const auto key = [](const EdgeUse& use) {
        return std::tie(use.group, use.low, use.high, use.triangle, use.direction);
    };
    tbb::parallel_sort(uses.begin(), uses.end(),
                       [&](const EdgeUse& a, const EdgeUse& b) { return key(a) < key(b); });
    return uses;
}

}  // namespace demolish
