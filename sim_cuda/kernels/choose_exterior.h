// SPDX-License-Identifier: Apache-2.0
// How each triangle of the mesh is drawn: in parts, or uncut through some of the points on its rim.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

/// The outside of a scene, static.
struct ExteriorMesh {
    Span<const ExteriorTriangle> triangles;
    Span<const uint32_t> cells, parts, rim;  ///< exterior_cells, exterior_indices, exterior_rim
};

struct MarkUncut {
    ExteriorMesh mesh;
    Span<const uint32_t> fragment;  ///< slot of each particle
    Span<uint8_t> uncut;

    DEM_FN void operator()(uint32_t t) const {
        const ExteriorTriangle& triangle = mesh.triangles[t];
        bool one = triangle.rim_count > 0;
        for (uint32_t c = 1; c < triangle.cell_count && one; ++c)
            one = fragment[mesh.cells[triangle.first_cell + c]] == fragment[mesh.cells[triangle.first_cell]];
        uncut[t] = one ? 1 : 0;
    }
};

/// An uncut triangle: a side has its points when the triangle beyond it is drawn in parts.
struct RimView {
    const ExteriorTriangle& triangle;
    Span<const uint32_t> rim;
    uint32_t points[3];  ///< on each side, both corners included

    DEM_FN RimView(const ExteriorMesh& mesh, Span<const uint8_t> uncut, uint32_t t)
        : triangle(mesh.triangles[t]), rim(mesh.rim), points{} {
        for (uint32_t side = 0; side < 3; ++side) {
            const uint32_t beyond = triangle.neighbour[side];
            const bool parted = beyond == kNoNeighbour || uncut[beyond] == 0;
            points[side] = parted ? begin(side + 1) - begin(side) + 1 : 2;
        }
    }

    DEM_FN uint32_t begin(uint32_t side) const {
        return side == 0
                   ? 0
                   : (side == 1 ? triangle.corner_1 : (side == 2 ? triangle.corner_2 : triangle.rim_count));
    }
    /// Exterior vertex k of a side, the last being the next side's first.
    DEM_FN uint32_t at(uint32_t side, uint32_t k) const {
        const uint32_t place = k + 1 < points[side] ? begin(side) + k : begin(side + 1);
        return rim[triangle.first_rim + (place < triangle.rim_count ? place : 0)];
    }
    /// Every triangulation of a polygon has as many triangles.
    DEM_FN uint32_t indexCount() const { return 3 * (points[0] + points[1] + points[2] - 5); }
};

struct CountExterior {
    ExteriorMesh mesh;
    Span<const uint8_t> uncut;
    Span<uint32_t> index_count;

    DEM_FN void operator()(uint32_t t) const {
        index_count[t] = uncut[t] != 0 ? RimView(mesh, uncut, t).indexCount() : mesh.triangles[t].index_count;
    }
};

}  // namespace demolish
