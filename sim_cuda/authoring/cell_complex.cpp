// SPDX-License-Identifier: Apache-2.0
// The stages of geometry.md 2 in order, and the fall-back for degenerate seeds.
#include "sim_cuda/authoring/cell_complex.h"

#include <algorithm>
#include <utility>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/cell_balance.h"
#include "sim_cuda/authoring/cut_off_parts.h"
#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/interior_faces.h"

namespace demolish {

namespace {

constexpr uint32_t kMostRejitterRounds = 3;
constexpr double kRejitter = 1e-6;                        // h
constexpr uint64_t kRejitterStream = 0x6a69747465720000;  // one stream a round

/// Keys of all corners of pieces, then of all vertices of cells; what is on a start cube has no key.
struct KeyList {
    std::vector<VertexKey> keys;
    std::vector<uint32_t> cell_vertex_start;
    std::vector<uint32_t> entry_of_cell_vertex;  // into keys, kNoCell at the start cube
};

KeyList listKeys(const VoronoiCells& cells, std::vector<VertexKey>&& of_pieces) {
    KeyList list;
    list.keys = std::move(of_pieces);
    list.cell_vertex_start.push_back(0);
    for (uint32_t cell = 0; cell < cells.size(); ++cell) {
        for (const auto& others : cells[cell].vertices) {
            const bool is_on_cube = std::find(others.begin(), others.end(), kNoCell) != others.end();
            list.entry_of_cell_vertex.push_back(is_on_cube ? kNoCell : uint32_t(list.keys.size()));
            if (!is_on_cube) list.keys.push_back(interiorKey(cell, others[0], others[1], others[2]));
        }
        list.cell_vertex_start.push_back(uint32_t(list.entry_of_cell_vertex.size()));
    }
    return list;
}

/// m, a cube of this half side round any seed holds the whole mesh.
double enoughForAll(const TriangleMesh& mesh, const std::vector<Double3>& seeds) {
    Bounds bounds = boundsOf(mesh.positions);
    bounds.add(seeds);
    const Double3 size = bounds.size();
    return std::max({size.x, size.y, size.z}) * 1.01;
}

/// One try with given seeds.
class ComplexBuilder {
  public:
    ComplexBuilder(const TriangleMesh& mesh, const MeshQueries& queries, const MeshEdges& edges,
                   const std::vector<Double3>& seeds, double spacing)
        : queries_(queries),
          seeds_(seeds),
          space_{mesh, edges, seeds},
          cells_(seeds, spacing),
          exterior_(space_, cells_),
          enough_(enoughForAll(mesh, seeds)) {}

    CellComplex build() {
        while (!grown(exterior_.cellsWithVerticesBeyondTheirCube()).empty()) {
        }
        exterior_.clip();
        for (;;) {
            while (growAndClip(exterior_.cellsThatOutgrowTheirCube())) {
            }
            GatheredPieces pieces = exterior_.gather();
            const size_t corners = pieces.keys.size();
            KeyList list = listKeys(cells_, std::move(pieces.keys));
            NumberedVertices numbered = numberVertices(space_, list.keys);
            for (uint32_t& entry : list.entry_of_cell_vertex)
                if (entry != kNoCell) entry = numbered.ids[entry];
            numbered.ids.resize(corners);
            InteriorFaces interior =
                makeInteriorFaces({queries_, seeds_, cells_, pieces, numbered.vertices, numbered.ids,
                                   list.cell_vertex_start, list.entry_of_cell_vertex});
            if (!growAndClip(interior.cut_short))
                return assemble(std::move(pieces), std::move(numbered), std::move(interior.arrays));
        }
    }

  private:
    /// Doubles the cubes of those that can grow, and returns them.
    std::vector<uint32_t> grown(std::vector<uint32_t> cells) {
        std::erase_if(cells, [&](uint32_t cell) { return cells_[cell].half_side >= enough_; });
        if (!cells.empty()) cells_.doubleCubes(cells);
        return cells;
    }

    /// False: none of them can or must grow.
    bool growAndClip(std::vector<uint32_t> cells) {
        cells = grown(std::move(cells));
        if (!cells.empty()) exterior_.clipAgain(cells);
        return !cells.empty();
    }

    CellComplex assemble(GatheredPieces&& pieces, NumberedVertices&& numbered, FaceArrays&& faces) const;

    const MeshQueries& queries_;
    const std::vector<Double3>& seeds_;
    KeySpace space_;
    VoronoiCells cells_;
    ExteriorPieces exterior_;
    double enough_;  // m
};

/// Leaves out the vertices of Voronoi cells outside the solid.
void dropUnusedVertices(CellComplex& complex) {
    std::vector<uint32_t> new_id(complex.vertices.size() + 1, 0);
    for (const uint32_t id : complex.exterior_loop) new_id[id + 1] = 1;
    for (const uint32_t id : complex.loop_vertices) new_id[id + 1] = 1;
    for (size_t id = 0; id < complex.vertices.size(); ++id) {  // the vertex's own id is the count before it
        if (new_id[id + 1] == 1) complex.vertices[new_id[id]] = complex.vertices[id];
        new_id[id + 1] += new_id[id];
    }
    complex.vertices.resize(new_id.back());
    for (uint32_t& id : complex.exterior_loop) id = new_id[id];
    for (uint32_t& id : complex.loop_vertices) id = new_id[id];
    for (auto& triangle : complex.face_triangles)
        for (uint32_t& id : triangle) id = new_id[id];
}

CellComplex ComplexBuilder::assemble(GatheredPieces&& pieces, NumberedVertices&& numbered,
                                     FaceArrays&& faces) const {
    CellComplex complex;
    complex.seeds = seeds_;
    complex.vertices = std::move(numbered.vertices);
    complex.pieces = std::move(pieces.pieces);
    complex.exterior_loop = std::move(numbered.ids);
    complex.exterior_barycentrics = std::move(pieces.barycentrics);
    complex.exterior_across = std::move(pieces.across);
    complex.faces = std::move(faces.faces);
    complex.loop_start = std::move(faces.loop_end);
    complex.loop_start.insert(complex.loop_start.begin(), 0u);
    complex.loop_vertices = std::move(faces.loop_vertices);
    complex.face_triangles = std::move(faces.triangles);
    complex.moved_parts = moveCutOffParts(complex);
    dropUnusedVertices(complex);
    return complex;
}

}  // namespace

CellComplex buildCellComplex(const TriangleMesh& mesh, const MeshQueries& queries, std::vector<Double3> seeds,
                             double spacing, uint64_t seed) {
    const MeshEdges edges(mesh);
    for (uint32_t round = 0;; ++round) {
        CellComplex complex = ComplexBuilder(mesh, queries, edges, seeds, spacing).build();
        complex.open_cells = findOpenCells(complex);
        complex.rejitter_rounds = round;
        if (complex.open_cells.empty() || round == kMostRejitterRounds) return complex;
        for (const uint32_t cell : complex.open_cells)
            seeds[cell] += hashRandomInCube(seed, kRejitterStream + round, cell) * (2 * kRejitter * spacing);
    }
}

}  // namespace demolish
