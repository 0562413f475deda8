// SPDX-License-Identifier: Apache-2.0
// Voronoi cells of all seeds within their start cubes, as flat arrays (geometry.md 2.2).
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "sim_cuda/authoring/cell_complex.h"
#include "sim_cuda/authoring/seed_grid.h"

namespace demolish {

/// One corner of a face's polygon.
struct CellCorner {
    uint16_t vertex;  ///< local vertex of the cell
    uint16_t across;  ///< local face beyond the edge to the next corner
};

/// Read-only view of one cell. Faces of neighbours come first, by their distance; then what is left of the
/// start cube, with neighbour kNoCell. Polygons are counter-clockwise seen from outside the cell.
struct VoronoiCell {
    std::span<const uint32_t> neighbours;    ///< by face
    std::span<const uint32_t> corner_start;  ///< by face, one past the end included
    std::span<const CellCorner> corners;
    std::span<const std::array<uint32_t, 3>>
        vertices;                        ///< the other seeds of each vertex; kNoCell: cube plane
    std::span<const Double3> positions;  ///< m, by vertex, relative to the seed
    double half_side = 0;                ///< m, of the start cube
    uint32_t seed_faces = 0;             ///< how many of the faces are with neighbours

    bool touchesCube() const { return seed_faces < neighbours.size(); }
};

class VoronoiCells {
  public:
    /// `spacing` h (m): the start cubes have half side 1.3 h. `seeds` must outlive this.
    VoronoiCells(const std::vector<Double3>& seeds, double spacing);

    size_t size() const { return cells_.size(); }
    const VoronoiCell& operator[](size_t cell) const { return cells_[cell]; }
    const SeedGrid& grid() const { return grid_; }

    /// Rebuilds these cells (sorted, no duplicates) from cubes of twice the size.
    void doubleCubes(const std::vector<uint32_t>& cells);

  private:
    struct Block;
    void build(std::span<const uint32_t> ids, Block& block);

    const std::vector<Double3>& seeds_;
    SeedGrid grid_;
    std::vector<VoronoiCell> cells_;
    std::vector<std::shared_ptr<const Block>> blocks_;  // own the arrays that cells_ points into
};

}  // namespace demolish
