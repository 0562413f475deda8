// SPDX-License-Identifier: Apache-2.0
// Signed distances on the nodes of a regular grid: how the distance grid is filled.
#pragma once
#include <vector>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

/// Nodes of a regular grid; x runs fastest.
struct NodeFrame {
    Double3 origin;   ///< m, node (0, 0, 0)
    double step = 0;  ///< m
    int nx = 0, ny = 0, nz = 0;

    size_t size() const { return size_t(nx) * size_t(ny) * size_t(nz); }
    size_t index(int i, int j, int k) const {
        return (size_t(k) * size_t(ny) + size_t(j)) * size_t(nx) + size_t(i);
    }
    Double3 node(int i, int j, int k) const { return origin + Double3{i * step, j * step, k * step}; }
};

/// m, negative inside (winding number > 0). Exact up to 1.8 steps from the surface, beyond it the distance to
/// a near surface point handed on from node to node (geometry.md 1). The same for any number of threads.
std::vector<float> signedDistances(const TriangleMesh& mesh, const MeshQueries& queries,
                                   const NodeFrame& frame);

}  // namespace demolish
