// SPDX-License-Identifier: Apache-2.0
// The mesh together with what is computed from it once: tree, distance grid, figures.
#pragma once
#include <mutex>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/model_looks.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/repair/repair.h"

namespace demolish {

class SolidMesh {
  public:
    /// `mesh` must be closed with positive volume (requireSolid). What may be done where its cells come out
    /// open or without volume is nothing.
    explicit SolidMesh(TriangleMesh mesh);
    /// The same, and with RepairMode::kAuto or kRemesh such a mesh may be given a new surface.
    SolidMesh(RepairedMesh repaired, RepairMode mode, std::shared_ptr<const ModelLooks> looks);

    const TriangleMesh& mesh() const { return mesh_; }
    const MeshQueries& queries() const { return queries_; }
    const DistanceGrid& grid() const { return grid_; }
    const SolidMeshInfo& info() const { return info_; }
    const RepairReport& repair() const { return repair_; }
    /// Null: none.
    const std::shared_ptr<const ModelLooks>& looks() const { return looks_; }
    /// By triangle, as RepairedMesh::source.
    const std::vector<uint32_t>& source() const { return source_; }

    /// The same body with a new surface, made at the first call; null where that is not allowed, or where the
    /// surface is a new one already. Any number of threads may ask.
    std::shared_ptr<const SolidMesh> withNewSurface() const;

  private:
    TriangleMesh mesh_;
    MeshQueries queries_;
    DistanceGrid grid_;
    SolidMeshInfo info_;
    RepairReport repair_;
    std::shared_ptr<const ModelLooks> looks_;
    std::vector<uint32_t> source_;
    bool may_remesh_ = false;
    mutable std::once_flag remesh_once_;
    mutable std::shared_ptr<const SolidMesh> remeshed_;
};

}  // namespace demolish
