// SPDX-License-Identifier: Apache-2.0
// The mesh's triangles as they are drawn: the parts of their cells, and the points round them.
#include <algorithm>
#include <utility>

#include "sim_cuda/authoring/fracture_geometry_parts.h"

namespace demolish {
namespace {

/// Numbers of the pieces of each mesh triangle, rows of a CSR.
struct PiecesOfTriangles {
    std::vector<uint32_t> start, piece;
};

PiecesOfTriangles piecesOfTriangles(const CellComplex& complex, size_t triangle_count) {
    PiecesOfTriangles rows;
    rows.start.assign(triangle_count + 1, 0);
    for (const ExteriorPiece& piece : complex.pieces) ++rows.start[piece.triangle + 1];
    for (size_t t = 0; t < triangle_count; ++t) rows.start[t + 1] += rows.start[t];
    rows.piece.resize(complex.pieces.size());
    std::vector<uint32_t> cursor(rows.start.begin(), rows.start.end() - 1);
    for (uint32_t p = 0; p < complex.pieces.size(); ++p) rows.piece[cursor[complex.pieces[p].triangle]++] = p;
    return rows;
}

/// A point on the rim of a mesh triangle.
struct RimPoint {
    uint32_t id;      ///< of the complex
    uint32_t next;    ///< id of the next point, counter-clockwise
    uint32_t vertex;  ///< exterior vertex
    bool is_corner;
};

/// Finds the triangle beyond a directed edge of the mesh.
class TrianglesByEdge {
  public:
    explicit TrianglesByEdge(const TriangleMesh& mesh) {
        for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (size_t k = 0; k < 3; ++k)
                entries_.push_back({keyOf(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]), t});
        std::sort(entries_.begin(), entries_.end());
    }
    /// That has the edge from u to v; kNoNeighbour when there is none.
    uint32_t find(uint32_t u, uint32_t v) const {
        const auto at =
            std::lower_bound(entries_.begin(), entries_.end(), std::pair{keyOf(u, v), uint32_t{0}});
        return at != entries_.end() && at->first == keyOf(u, v) ? at->second : kNoNeighbour;
    }

  private:
    static uint64_t keyOf(uint32_t u, uint32_t v) { return uint64_t{u} << 32 | v; }
    std::vector<std::pair<uint64_t, uint32_t>> entries_;
};

/// The points round a mesh triangle, from a corner on.
class Rims {
  public:
    Rims(const CellComplex& complex, const TriangleMesh& mesh, const std::vector<uint32_t>& corner_vertex)
        : complex_(complex), corner_vertex_(corner_vertex), triangles_(mesh) {}

    /// Sets rim and neighbours of `triangle` and appends its points to `rim`; nothing where the pieces' rim
    /// is not one loop with three corners (degenerate input).
    void append(const uint32_t* first_piece, const uint32_t* end_piece, ExteriorTriangle& triangle,
                std::vector<uint32_t>& rim) {
        points_.clear();
        for (const uint32_t* p = first_piece; p != end_piece; ++p) addPoints(complex_.pieces[*p]);
        std::sort(points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
        if (!walk()) return;
        triangle.first_rim = static_cast<uint32_t>(rim.size());
        triangle.rim_count = static_cast<uint32_t>(loop_.size());
        triangle.corner_1 = corners_[1];
        triangle.corner_2 = corners_[2];
        for (size_t side = 0; side < 3; ++side)
            triangle.neighbour[side] = triangles_.find(meshVertex((side + 1) % 3), meshVertex(side));
        for (const RimPoint* point : loop_) rim.push_back(point->vertex);
    }

  private:
    void addPoints(const ExteriorPiece& piece) {
        for (uint32_t corner = 0; corner < piece.count; ++corner) {
            const uint32_t at = piece.first + corner;
            if (complex_.exterior_across[at] != kNoCell) continue;
            const uint32_t id = complex_.exterior_loop[at];
            points_.push_back({id, complex_.exterior_loop[piece.first + (corner + 1) % piece.count],
                               corner_vertex_[at], complex_.vertices[id].key.kind == VertexKind::kMesh});
        }
    }

    const RimPoint* find(uint32_t id) const {
        const auto at = std::lower_bound(points_.begin(), points_.end(), id,
                                         [](const auto& p, uint32_t v) { return p.id < v; });
        return at != points_.end() && at->id == id ? &*at : nullptr;
    }

    bool walk() {
        loop_.clear();
        corners_.clear();
        const auto corner =
            std::find_if(points_.begin(), points_.end(), [](const auto& p) { return p.is_corner; });
        if (corner == points_.end()) return false;
        const RimPoint* at = &*corner;
        do {
            if (at->is_corner) corners_.push_back(static_cast<uint32_t>(loop_.size()));
            loop_.push_back(at);
            at = find(at->next);
        } while (at != nullptr && at != &*corner && loop_.size() < points_.size());
        return at == &*corner && loop_.size() == points_.size() && corners_.size() == 3;
    }

    uint32_t meshVertex(size_t corner) const {
        return complex_.vertices[loop_[corners_[corner]]->id].key.ids[0];
    }

    const CellComplex& complex_;
    const std::vector<uint32_t>& corner_vertex_;
    TrianglesByEdge triangles_;
    std::vector<RimPoint> points_;
    std::vector<const RimPoint*> loop_;
    std::vector<uint32_t> corners_;  ///< places in the loop
};

void appendPiece(const ExteriorPiece& piece, const std::vector<uint32_t>& corner_vertex,
                 std::vector<uint32_t>& indices) {
    const uint32_t* ring = &corner_vertex[piece.first];
    for (uint32_t corner = 2; corner < piece.count; ++corner)
        indices.insert(indices.end(), {ring[0], ring[corner - 1], ring[corner]});
}

uint32_t count(const auto& elements) {
    return static_cast<uint32_t>(elements.size());
}

}  // namespace

void listExteriorTriangles(const TriangleMesh& mesh, const CellComplex& complex,
                           const std::vector<uint32_t>& corner_vertex, FractureGeometry& geometry) {
    const PiecesOfTriangles rows = piecesOfTriangles(complex, mesh.triangles.size());
    Rims rims(complex, mesh, corner_vertex);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uint32_t *first = rows.piece.data() + rows.start[t],
                       *end = rows.piece.data() + rows.start[t + 1];
        ExteriorTriangle triangle{
            count(geometry.exterior_indices),          0, count(geometry.exterior_cells), 0, 0, 0, 0, 0,
            {kNoNeighbour, kNoNeighbour, kNoNeighbour}};
        for (const uint32_t* p = first; p != end; ++p) {
            appendPiece(complex.pieces[*p], corner_vertex, geometry.exterior_indices);
            // Pieces stand in the order of their cells.
            if (p == first || complex.pieces[p[-1]].cell != complex.pieces[*p].cell)
                geometry.exterior_cells.push_back(complex.pieces[*p].cell);
        }
        triangle.index_count = count(geometry.exterior_indices) - triangle.first_index;
        triangle.cell_count = count(geometry.exterior_cells) - triangle.first_cell;
        rims.append(first, end, triangle, geometry.exterior_rim);
        geometry.exterior_triangles.push_back(triangle);
    }
}

}  // namespace demolish
