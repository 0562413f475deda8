// SPDX-License-Identifier: Apache-2.0
// The faces between cells, cut to the solid by winding numbers (geometry.md 2.4).
#pragma once
#include <vector>

#include "sim_cuda/authoring/exterior_pieces.h"
#include "sim_cuda/authoring/face_loops.h"

namespace demolish {

/// What the faces are made from.
struct FaceSources {
    const MeshQueries& queries;
    const std::vector<Double3>& seeds;
    const VoronoiCells& cells;
    const GatheredPieces& pieces;
    const std::vector<ComplexVertex>& vertices;
    const std::vector<uint32_t>& corner_ids;         ///< vertex id by corner of the pieces
    const std::vector<uint32_t>& cell_vertex_start;  ///< by cell, into cell_vertex_ids
    const std::vector<uint32_t>& cell_vertex_ids;    ///< by local vertex; kNoCell at the start cube
};

struct InteriorFaces {
    FaceArrays arrays;                ///< sorted by (cell_a, cell_b)
    std::vector<uint32_t> cut_short;  ///< cells whose solid goes on beyond their start cube; sorted
};

/// Face (i, j), i < j, is made once, from cell i.
InteriorFaces makeInteriorFaces(const FaceSources& sources);

}  // namespace demolish
