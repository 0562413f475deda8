// SPDX-License-Identifier: Apache-2.0
// One triangle flooded through the cells that it meets, cut by their planes with symbolic corners.
#pragma once
#include <vector>

#include "sim_cuda/authoring/vertex_keys.h"
#include "sim_cuda/authoring/voronoi_cells.h"

namespace demolish {

class TriangleClipper {
  public:
    struct Corner {
        VertexKey key;
        Double3 position, barycentrics;
        uint32_t
            mesh_side;    ///< side of the triangle that leads to the next corner, kNoSide where a cell cut it
        uint32_t across;  ///< cell beyond the way to the next corner, kNoCell on a mesh side
        double side;      ///< of the plane being cut with
    };
    static constexpr uint32_t kNoSide = 3;

    TriangleClipper(const KeySpace& space, const VoronoiCells& cells) : space_(space), cells_(cells) {}

    /// Calls emit(cell, corners) for every piece, at least three corners each; `owners` are the cells of the
    /// triangle's corners.
    template <typename Emit>
    void clip(uint32_t triangle, const std::array<uint32_t, 3>& owners, Emit&& emit) {
        startFlood(triangle, owners);
        const bool is_whole = owners[0] == owners[1] && owners[1] == owners[2];  // cells are convex
        for (size_t next = 0; next < flood_.size(); ++next) {
            loadTriangle();
            if (!is_whole) cutByCell(flood_[next]);
            if (polygon_.size() >= 3) emit(flood_[next], polygon_);
        }
    }

  private:
    void startFlood(uint32_t triangle, const std::array<uint32_t, 3>& owners);
    void loadTriangle();
    void cutByCell(uint32_t cell);
    bool cutByPlane(uint32_t cell, uint32_t neighbour);
    Corner crossing(const Corner& from, uint32_t cell, uint32_t neighbour) const;
    void visit(uint32_t cell);

    const KeySpace& space_;
    const VoronoiCells& cells_;
    uint32_t triangle_ = 0;
    std::vector<Corner> polygon_, cut_;
    std::vector<uint32_t> flood_;    // cells in order of discovery
    std::vector<uint32_t> visited_;  // open addressing, kNoCell: free; used once the flood is long
};

}  // namespace demolish
