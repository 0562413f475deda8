// SPDX-License-Identifier: Apache-2.0
// Which closed parts of a mesh points lie in.
#pragma once
#include <optional>
#include <vector>

#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

class PartsAbout {
  public:
    /// The mesh must outlive this.
    explicit PartsAbout(const RepairMesh& repair) : repair_(repair) {}

    /// Parts about each of the points, ascending: those in which its winding number is above 0. Each by a ray
    /// of its own.
    std::vector<std::vector<uint32_t>> each(const std::vector<Double3>& points);

    /// The same of points of a grid in its order, x first: one line for all that have y and z in common.
    std::vector<std::vector<uint32_t>> eachOfGrid(const std::vector<Double3>& points);

  private:
    std::vector<uint32_t> aboutByRay(const Double3& point) const;
    const MeshQueries& queries();

    const RepairMesh& repair_;
    std::optional<MeshQueries> queries_;  // once they are needed
};

}  // namespace demolish
