// SPDX-License-Identifier: Apache-2.0
// Nodes that a file's animations move.
#pragma once
#include <assimp/scene.h>

#include <vector>

#include "sim_cuda/authoring/node_transform.h"

namespace demolish {

/// A node with all above it. Of several animations that move one node the first counts.
class NodeMotion {
  public:
    NodeMotion(const aiScene& scene, const aiNode& node);
    /// s, ascending, above 0 and at most an hour: where keys lie. Empty: nothing moves it.
    const std::vector<double>& times() const { return times_; }
    /// From the node's own lengths to the file's; `time` in s. Keys that are no numbers give such a place.
    NodeTransform at(double time) const;

  private:
    struct Link {
        const aiNode* node = nullptr;
        const aiNodeAnim* channel = nullptr;  ///< null: it stands
        double ticks_per_second = 1;
    };
    std::vector<Link> chain_;  ///< from the root down
    std::vector<double> times_;
};

}  // namespace demolish
