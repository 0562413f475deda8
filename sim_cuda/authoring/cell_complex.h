// SPDX-License-Identifier: Apache-2.0
// The solid cut into Voronoi cells: exact topology by symbolic vertices (geometry.md 2). Made by
// buildCellComplex(), read by the draw geometry, the bonds and the mass properties.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

enum class VertexKind : uint32_t { kMesh, kMeshEdge, kTriangle, kInterior };  // A, B, C, D

/// A: {mesh vertex,-,-,-}; B: {edge, i, j, -}; C: {triangle, i, j, k}; D: {i, j, k, l}; seeds ascending.
struct VertexKey {
    VertexKind kind = VertexKind::kInterior;
    std::array<uint32_t, 4> ids{};
    auto operator<=>(const VertexKey&) const = default;
};

struct ComplexVertex {
    VertexKey key;
    Double3 position;  ///< computed from the key alone: the same bits for everyone who shares it
};

/// Part of a mesh triangle that belongs to one cell; convex, counter-clockwise seen from outside.
struct ExteriorPiece {
    uint32_t cell = 0;
    uint32_t triangle = 0;
    uint32_t first = 0, count = 0;  ///< into exterior_loop / exterior_barycentrics / exterior_across
};

inline constexpr uint32_t kNoCell = 0xffffffffu;

/// One connected part of the face between two cells: an outer loop and holes, counter-clockwise seen from
/// cell_b (the normal points from cell_a to cell_b), with a triangulation of it.
struct ComplexFace {
    uint32_t cell_a = 0, cell_b = 0;          ///< cell_a < cell_b
    uint32_t first_loop = 0, loop_count = 0;  ///< into loop_start; the first is the outer one
    uint32_t first_triangle = 0, triangle_count = 0;
    double area = 0;  ///< m^2
    Double3 centroid;
};

struct CellComplex {
    std::vector<Double3> seeds;
    std::vector<ComplexVertex> vertices;         ///< unique by key, sorted by key
    std::vector<ExteriorPiece> pieces;           ///< sorted by (cell, triangle)
    std::vector<uint32_t> exterior_loop;         ///< vertex ids
    std::vector<Double3> exterior_barycentrics;  ///< in the piece's mesh triangle
    std::vector<uint32_t> exterior_across;  ///< cell across the edge to the next vertex; kNoCell: mesh edge
    std::vector<ComplexFace> faces;         ///< sorted by (cell_a, cell_b)
    std::vector<uint32_t> loop_start;       ///< into loop_vertices, one past the end included
    std::vector<uint32_t> loop_vertices;    ///< vertex ids
    std::vector<std::array<uint32_t, 3>> face_triangles;  ///< vertex ids
    std::vector<uint32_t> open_cells;                     ///< with an unbalanced edge (only degenerate input)
    uint32_t moved_parts = 0;      ///< parts cut off from their seed that now belong to a neighbour
    uint32_t rejitter_rounds = 0;  ///< how often seeds had to be moved by 1e-6 h
};

/// Exact and watertight; the same for any number of threads. Degenerate seeds are moved at most 3 times. What
/// a thin wall or a gap cuts off from its seed belongs to a neighbour (cut_off_parts.h): every cell is in one
/// piece, and then not convex.
CellComplex buildCellComplex(const TriangleMesh& mesh, const MeshQueries& queries, std::vector<Double3> seeds,
                             double spacing, uint64_t seed);

/// Per cell the edges not used equally often in both directions, by vertex ids; 0 for a closed cell.
std::vector<uint32_t> unbalancedEdges(const CellComplex& complex);

}  // namespace demolish
