// SPDX-License-Identifier: Apache-2.0
// The mesh's triangles cut by the cells: what of the surface belongs to whom (geometry.md 2.3).
#pragma once
#include <memory>
#include <vector>

#include "sim_cuda/authoring/vertex_keys.h"
#include "sim_cuda/authoring/voronoi_cells.h"

namespace demolish {

/// Pieces sorted by (cell, triangle), with flat arrays over their corners as in CellComplex.
struct GatheredPieces {
    std::vector<ExteriorPiece> pieces;
    std::vector<VertexKey> keys;
    std::vector<Double3> barycentrics;
    std::vector<uint32_t> across;
    std::vector<uint32_t> cell_start;  ///< into pieces, one past the end included
};

class ExteriorPieces {
  public:
    /// The arguments must outlive this.
    ExteriorPieces(const KeySpace& space, const VoronoiCells& cells);
    ~ExteriorPieces();

    /// Cells whose start cube does not hold all their vertices of the mesh (sorted): told before a triangle
    /// is clipped, since each clip with cubes too small is one in vain.
    std::vector<uint32_t> cellsWithVerticesBeyondTheirCube() const;
    /// Clips every triangle.
    void clip();
    /// Cells whose start cube does not hold all their pieces (sorted): their cubes have to grow.
    std::vector<uint32_t> cellsThatOutgrowTheirCube() const;
    /// Clips the triangles again that have pieces in these cells (sorted).
    void clipAgain(const std::vector<uint32_t>& cells);

    GatheredPieces gather() const;

  private:
    struct Block;
    void clipBlock(size_t block);

    const KeySpace& space_;
    const VoronoiCells& cells_;
    std::vector<uint32_t> owner_of_vertex_;
    std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace demolish
