// SPDX-License-Identifier: Apache-2.0
// The mesh together with what is computed from it once: tree, distance grid, figures.
#pragma once
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

class SolidMesh {
  public:
    /// `mesh` must be closed with positive volume (requireSolid).
    explicit SolidMesh(TriangleMesh mesh);

    const TriangleMesh& mesh() const { return mesh_; }
    const MeshQueries& queries() const { return queries_; }
    const DistanceGrid& grid() const { return grid_; }
    const SolidMeshInfo& info() const { return info_; }

  private:
    TriangleMesh mesh_;
    MeshQueries queries_;
    DistanceGrid grid_;
    SolidMeshInfo info_;
};

}  // namespace demolish
