// SPDX-License-Identifier: Apache-2.0
// The steps of makeFractureGeometry(): exterior, split Voronoi edges, tessellated faces, corner lists.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/authoring/cell_complex.h"

namespace demolish {

/// Finds the bond of a pair of cells.
class BondLookup {
  public:
    BondLookup(const std::vector<BondGeometry>& bonds, size_t cell_count);
    /// Index of the bond, i < j; kNoBond when there is none.
    uint32_t find(uint32_t i, uint32_t j) const;

  private:
    std::vector<uint32_t> start_;   ///< first bond of every lower cell
    std::vector<uint32_t> higher_;  ///< j of every bond
};

/// Exterior vertices by cell, their triangles and the crack edges (X and K of geometry.md 6). Returns the
/// exterior vertex at each entry of complex.exterior_loop.
std::vector<uint32_t> makeExterior(const TriangleMesh& mesh, const CellComplex& complex,
                                   const BondLookup& bonds, FractureGeometry& geometry);

/// Fills exterior_triangles, exterior_cells, exterior_indices and exterior_rim. `corner_vertex`: the exterior
/// vertex at each entry of complex.exterior_loop.
void listExteriorTriangles(const TriangleMesh& mesh, const CellComplex& complex,
                           const std::vector<uint32_t>& corner_vertex, FractureGeometry& geometry);

/// Voronoi edges inside the solid, cut into equal parts no longer than a given length. Cells that share an
/// edge share the cuts; segments of the outer surface are never cut.
struct SplitEdges {
    struct Edge {
        uint32_t higher;       ///< complex vertex at the far end; the near end is the row
        uint32_t first_split;  ///< among the split points, counted from the lower end
        uint32_t parts;
    };
    std::vector<uint32_t> row_start;  ///< by complex vertex (lower end), into edges
    std::vector<Edge> edges;          ///< sorted by `higher` within a row
    std::vector<Double3> points;      ///< m

    /// Null for a surface segment or a diagonal.
    const Edge* find(uint32_t u, uint32_t v) const;
};
SplitEdges splitVoronoiEdges(const CellComplex& complex, double longest);

/// Fills pool, pool_on_surface, faces, face_vertices and face_indices. Pool order: complex vertices that lie
/// on faces, split points, centres of faces. Returns the pool vertex of each complex vertex, or kNoPool.
std::vector<uint32_t> tessellateFaces(const CellComplex& complex, const SplitEdges& split,
                                      const BondLookup& bonds, FractureGeometry& geometry);

/// Fills points, exterior_home, mesh_triangles, looks, point_corner_* and point_crack*. `corner_vertex` as
/// makeExterior(), `pool_of_vertex` as tessellateFaces() returns it.
void listOutsidePoints(const TriangleMesh& mesh, const CellComplex& complex,
                       const std::vector<uint32_t>& corner_vertex,
                       const std::vector<uint32_t>& pool_of_vertex, FractureGeometry& geometry);

/// Fills pool_corner_*: every triangle corner at a pool vertex, in order of faces and triangles.
void listPoolCorners(FractureGeometry& geometry);

}  // namespace demolish
