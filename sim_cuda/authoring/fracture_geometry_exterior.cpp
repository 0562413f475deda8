// SPDX-License-Identifier: Apache-2.0
// The outside of the body cut into cells: vertices with the artist's normals and UVs, and the cracks that may
// show on it.
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "sim_cuda/authoring/corner_looks.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/fracture_geometry_parts.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish {
namespace {

constexpr uint32_t kCellsPerChunk = 64;  // fixed, so that the result does not depend on the threads
constexpr uint32_t kEmpty = 0xffffffffu;

/// Merges the corners of one cell that agree in position (by vertex id), normal and looks: open addressing.
class CornerMerger {
  public:
    void startCell(size_t most_corners) {
        slots_.assign(std::bit_ceil(2 * most_corners + 1), kEmpty);
        ids_.clear();
    }

    /// Index of the vertex in `vertices`, appended when it is new; the cell's vertices start at `first`.
    uint32_t merge(uint32_t complex_vertex, const SurfaceVertex& vertex, uint32_t chart,
                   std::vector<SurfaceVertex>& vertices, uint32_t first) {
        const size_t mask = slots_.size() - 1;
        const uint32_t hash =
            (complex_vertex * 0x9e3779b1u ^ vertex.normal * 0x85ebca6bu) ^ chart * 0xc2b2ae35u;
        for (size_t slot = (hash ^ hash >> 15) & mask;; slot = (slot + 1) & mask) {
            const uint32_t at = slots_[slot];
            if (at == kEmpty) {
                slots_[slot] = static_cast<uint32_t>(vertices.size());
                ids_.push_back({complex_vertex, chart});
                vertices.push_back(vertex);
                return slots_[slot];
            }
            if (ids_[at - first] == Id{complex_vertex, chart} && vertices[at].normal == vertex.normal)
                return at;
        }
    }

  private:
    struct Id {
        uint32_t complex_vertex, chart;
        bool operator==(const Id&) const = default;
    };
    std::vector<uint32_t> slots_;  ///< vertex index or kEmpty
    std::vector<Id> ids_;          ///< of each of the cell's vertices
};

/// What a run of cells gives, with vertex numbers counted from the run's first vertex.
struct ExteriorChunk {
    std::vector<SurfaceVertex> vertices;
    std::vector<CrackEdge> cracks;
};

double blend(const Double3& weight, double at_a, double at_b, double at_c) {
    return at_a * weight.x + at_b * weight.y + at_c * weight.z;
}

SurfaceVertex cornerVertex(const TriangleMesh& mesh, const CellComplex& complex, const ExteriorPiece& piece,
                           uint32_t corner) {
    const Double3 weight = complex.exterior_barycentrics[piece.first + corner];
    const auto& [a, b, c] = mesh.corners[piece.triangle];
    const Double3 normal = normalized({blend(weight, a.normal.x, b.normal.x, c.normal.x),
                                       blend(weight, a.normal.y, b.normal.y, c.normal.y),
                                       blend(weight, a.normal.z, b.normal.z, c.normal.z)});
    const Double3& p = complex.vertices[complex.exterior_loop[piece.first + corner]].position;
    return {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
            packOctahedral(static_cast<float>(normal.x), static_cast<float>(normal.y),
                           static_cast<float>(normal.z)),
            piece.triangle,
            piece.cell};
}

uint32_t chartAt(const TriangleMesh& mesh, const CellComplex& complex, const ExteriorPiece& piece,
                 uint32_t corner) {
    const Double3 weight = complex.exterior_barycentrics[piece.first + corner];
    const auto& [a, b, c] = mesh.corners[piece.triangle];
    CornerAttributes blended = a;
    const auto blendUvs = [&](const Float2& at_a, const Float2& at_b, const Float2& at_c) {
        return Float2{static_cast<float>(blend(weight, at_a.x, at_b.x, at_c.x)),
                      static_cast<float>(blend(weight, at_a.y, at_b.y, at_c.y))};
    };
    blended.uv = blendUvs(a.uv, b.uv, c.uv);
    blended.second_uv = blendUvs(a.second_uv, b.second_uv, c.second_uv);
    if (a.colour != b.colour || a.colour != c.colour)
        blended.colour = blendColours({a.colour, b.colour, c.colour}, {weight.x, weight.y, weight.z});
    return chartOf(blended);
}

/// Vertices of one convex piece, and the crack edges along it that its cell owns. `ring`: the vertices'
/// numbers.
void addPiece(const TriangleMesh& mesh, const CellComplex& complex, const BondLookup& bonds,
              const ExteriorPiece& piece, uint32_t first, CornerMerger& merger, uint32_t* ring,
              ExteriorChunk& chunk) {
    for (uint32_t corner = 0; corner < piece.count; ++corner)
        ring[corner] = merger.merge(complex.exterior_loop[piece.first + corner],
                                    cornerVertex(mesh, complex, piece, corner),
                                    chartAt(mesh, complex, piece, corner), chunk.vertices, first);
    for (uint32_t corner = 0; corner < piece.count; ++corner) {
        const uint32_t across = complex.exterior_across[piece.first + corner];
        if (across == kNoCell || across <= piece.cell) continue;  // the lower cell draws it
        chunk.cracks.push_back({ring[corner], ring[(corner + 1) % piece.count], piece.cell, across,
                                bonds.find(piece.cell, across)});
    }
}

void addCells(const TriangleMesh& mesh, const CellComplex& complex, const BondLookup& bonds,
              const std::vector<uint32_t>& piece_start, uint32_t first_cell, uint32_t end_cell,
              std::vector<uint32_t>& corner_vertex, ExteriorChunk& chunk) {
    CornerMerger merger;
    for (uint32_t cell = first_cell; cell < end_cell; ++cell) {
        size_t corners = 0;
        for (uint32_t p = piece_start[cell]; p < piece_start[cell + 1]; ++p)
            corners += complex.pieces[p].count;
        if (corners == 0) continue;
        merger.startCell(corners);
        const auto first = static_cast<uint32_t>(chunk.vertices.size());
        for (uint32_t p = piece_start[cell]; p < piece_start[cell + 1]; ++p)
            addPiece(mesh, complex, bonds, complex.pieces[p], first, merger,
                     &corner_vertex[complex.pieces[p].first], chunk);
    }
}

/// Pieces are sorted by cell: where each cell's begin.
std::vector<uint32_t> pieceStarts(const CellComplex& complex) {
    std::vector<uint32_t> start(complex.seeds.size() + 1, 0);
    for (const ExteriorPiece& piece : complex.pieces) ++start[piece.cell + 1];
    for (size_t cell = 0; cell + 1 < start.size(); ++cell) start[cell + 1] += start[cell];
    return start;
}

/// `corner_vertex` counts from the first vertex of the corner's chunk, and afterwards from the first of all.
void joinChunks(const CellComplex& complex, const std::vector<uint32_t>& piece_start,
                const std::vector<ExteriorChunk>& chunks, std::vector<uint32_t>& corner_vertex,
                FractureGeometry& geometry) {
    struct Offsets {
        size_t vertex = 0, crack = 0;
    };
    std::vector<Offsets> offsets(chunks.size() + 1);
    for (size_t c = 0; c < chunks.size(); ++c)
        offsets[c + 1] = {offsets[c].vertex + chunks[c].vertices.size(),
                          offsets[c].crack + chunks[c].cracks.size()};
    geometry.exterior.resize(offsets.back().vertex);
    geometry.crack_edges.resize(offsets.back().crack);
    tbb::parallel_for(size_t{0}, chunks.size(), [&](size_t c) {
        const auto base = static_cast<uint32_t>(offsets[c].vertex);
        std::copy(chunks[c].vertices.begin(), chunks[c].vertices.end(), geometry.exterior.begin() + base);
        const size_t end_cell = std::min((c + 1) * kCellsPerChunk, complex.seeds.size());
        for (uint32_t p = piece_start[c * kCellsPerChunk]; p < piece_start[end_cell]; ++p)
            for (uint32_t corner = 0; corner < complex.pieces[p].count; ++corner)
                corner_vertex[complex.pieces[p].first + corner] += base;
        for (size_t i = 0; i < chunks[c].cracks.size(); ++i) {
            CrackEdge crack = chunks[c].cracks[i];
            crack.vertex_0 += base;
            crack.vertex_1 += base;
            geometry.crack_edges[offsets[c].crack + i] = crack;
        }
    });
}

}  // namespace

std::vector<uint32_t> makeExterior(const TriangleMesh& mesh, const CellComplex& complex,
                                   const BondLookup& bonds, FractureGeometry& geometry) {
    const std::vector<uint32_t> piece_start = pieceStarts(complex);
    const auto cell_count = static_cast<uint32_t>(complex.seeds.size());
    std::vector<uint32_t> corner_vertex(complex.exterior_loop.size());
    std::vector<ExteriorChunk> chunks((cell_count + kCellsPerChunk - 1) / kCellsPerChunk);
    tbb::parallel_for(size_t{0}, chunks.size(), [&](size_t c) {
        const uint32_t first = static_cast<uint32_t>(c) * kCellsPerChunk;
        addCells(mesh, complex, bonds, piece_start, first, std::min(first + kCellsPerChunk, cell_count),
                 corner_vertex, chunks[c]);
    });
    joinChunks(complex, piece_start, chunks, corner_vertex, geometry);
    listExteriorTriangles(mesh, complex, corner_vertex, geometry);
    return corner_vertex;
}

}  // namespace demolish
