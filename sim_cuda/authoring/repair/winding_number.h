// SPDX-License-Identifier: Apache-2.0
// The generalized winding number (Jacobson et al. 2013): how far a point is inside a mesh that need not be
// closed.
#pragma once
#include <vector>

#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// The solid angles of all triangles, summed through a tree: far groups of triangles count as one dipole
/// (Barill et al. 2018). 1 inside and 0 outside of something closed, in between near holes; within 0.02.
class WindingNumber {
  public:
    /// Of the triangles whose flag is not 0; all without flags.
    explicit WindingNumber(const TriangleMesh& mesh, const std::vector<char>& flags = {});

    WindingNumber(const std::vector<Double3>& positions, const std::vector<Triangle>& triangles);

    double at(const Double3& point) const;

  private:
    struct Node {
        Double3 centre, dipole;         // m; m^2, areas times normals
        double radius = 0;              // m, of all corners about the centre
        uint32_t first = 0, count = 0;  // triangles of a leaf; inner nodes have none
        uint32_t right = 0;             // the left child is the next node
    };
    uint32_t build(uint32_t begin, uint32_t end);
    Node summed(uint32_t begin, uint32_t end) const;

    std::vector<std::array<Double3, 3>> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace demolish
