// SPDX-License-Identifier: Apache-2.0
// Clips every triangle by the slabs and chains the cuts round the body into one loop a plane.
#include "tests/unit/draw/slab_complex.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace demolish::test {
namespace {

struct Corner {
    VertexKey key;
    Double3 barycentrics;
    double x;
};

class SlabCutter {
  public:
    SlabCutter(const TriangleMesh& mesh, const std::vector<double>& seed_x) : mesh_(mesh) {
        for (const double x : seed_x) complex_.seeds.push_back({x, 0, 0});
        for (size_t i = 0; i + 1 < seed_x.size(); ++i) planes_.push_back((seed_x[i] + seed_x[i + 1]) / 2);
    }

    CellComplex cut() {
        for (uint32_t cell = 0; cell < complex_.seeds.size(); ++cell)
            for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) addPiece(cell, t);
        sortVertices();
        for (uint32_t plane = 0; plane < planes_.size(); ++plane) addFace(plane);
        complex_.loop_start.push_back(static_cast<uint32_t>(complex_.loop_vertices.size()));
        return complex_;
    }

  private:
    uint32_t edgeId(uint32_t u, uint32_t v) {
        return edge_ids_
            .try_emplace({std::min(u, v), std::max(u, v)}, static_cast<uint32_t>(edge_ids_.size()))
            .first->second;
    }

    /// The point of mesh edge (u, v) on a plane, computed from the lower vertex on.
    Double3 cutPoint(uint32_t u, uint32_t v, double plane) const {
        const Double3 &a = mesh_.positions[std::min(u, v)], &b = mesh_.positions[std::max(u, v)];
        const double s = (plane - a.x) / (b.x - a.x);
        return {plane, a.y + (b.y - a.y) * s, a.z + (b.z - a.z) * s};
    }

    uint32_t vertex(const VertexKey& key, const Double3& position) {
        const auto [at, fresh] = ids_.try_emplace(key, static_cast<uint32_t>(complex_.vertices.size()));
        if (fresh) complex_.vertices.push_back({key, position});
        return at->second;
    }

    struct Node {
        uint32_t vertex;
        Double3 barycentrics;
        uint32_t across;  ///< label of the edge to the next node
    };

    void addPiece(uint32_t cell, uint32_t t) {
        const auto& corners = mesh_.triangles[t];
        const double low = cell == 0 ? -1e300 : planes_[cell - 1];
        const double high = cell == planes_.size() ? 1e300 : planes_[cell];
        std::vector<Node> nodes;
        for (uint32_t c = 0; c < 3; ++c) {
            const uint32_t u = corners[c], v = corners[(c + 1) % 3];
            const double xu = mesh_.positions[u].x, xv = mesh_.positions[v].x;
            const auto at = [&](double s) {
                std::array<double, 3> weights{};
                weights[c] = 1 - s;
                weights[(c + 1) % 3] += s;
                return Double3{weights[0], weights[1], weights[2]};
            };
            if (xu > low && xu < high)
                nodes.push_back(
                    {vertex({VertexKind::kMesh, {u, 0, 0, 0}}, mesh_.positions[u]), at(0), kNoCell});
            const auto crossing = [&](double plane, uint32_t lower_cell) {
                if ((xu - plane) * (xv - plane) >= 0) return;
                const VertexKey key{VertexKind::kMeshEdge, {edgeId(u, v), lower_cell, lower_cell + 1, 0}};
                const bool leaves = (plane == high) == (xv > xu);
                nodes.push_back({vertex(key, cutPoint(u, v, plane)), at((plane - xu) / (xv - xu)),
                                 leaves ? (plane == high ? cell + 1 : cell - 1) : kNoCell});
            };
            if (xv > xu) {
                crossing(low, cell - 1);
                crossing(high, cell);
            } else {
                crossing(high, cell);
                crossing(low, cell - 1);
            }
        }
        if (nodes.empty()) return;
        complex_.pieces.push_back({cell, t, static_cast<uint32_t>(complex_.exterior_loop.size()),
                                   static_cast<uint32_t>(nodes.size())});
        for (const Node& node : nodes) {
            complex_.exterior_loop.push_back(node.vertex);
            complex_.exterior_barycentrics.push_back(node.barycentrics);
            complex_.exterior_across.push_back(node.across);
        }
    }

    void sortVertices() {
        std::vector<ComplexVertex> sorted = complex_.vertices;
        std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
        for (size_t v = 0; v < sorted.size(); ++v) ids_[sorted[v].key] = static_cast<uint32_t>(v);
        for (uint32_t& v : complex_.exterior_loop) v = ids_[complex_.vertices[v].key];
        complex_.vertices = sorted;
    }

    void addFace(uint32_t plane) {
        std::map<uint32_t, uint32_t> next;  // reversed cuts of the lower cell's pieces
        for (const ExteriorPiece& piece : complex_.pieces) {
            if (piece.cell != plane) continue;
            for (uint32_t c = 0; c < piece.count; ++c) {
                if (complex_.exterior_across[piece.first + c] != plane + 1) continue;
                next[complex_.exterior_loop[piece.first + (c + 1) % piece.count]] =
                    complex_.exterior_loop[piece.first + c];
            }
        }
        ComplexFace face;
        face.cell_a = plane;
        face.cell_b = plane + 1;
        face.first_loop = static_cast<uint32_t>(complex_.loop_start.size());
        face.loop_count = 1;
        face.first_triangle = static_cast<uint32_t>(complex_.face_triangles.size());
        complex_.loop_start.push_back(static_cast<uint32_t>(complex_.loop_vertices.size()));
        std::vector<uint32_t> loop;
        for (uint32_t v = next.begin()->first; loop.size() < next.size(); v = next.at(v)) loop.push_back(v);
        if (next.at(loop.back()) != loop.front()) throw std::logic_error("the cut is not one loop");
        for (const uint32_t v : loop) {
            const Double3& p = complex_.vertices[v].position;
            const double share = 1.0 / static_cast<double>(loop.size());
            face.centroid = {p.x, face.centroid.y + p.y * share, face.centroid.z + p.z * share};
        }
        for (size_t v = 2; v < loop.size(); ++v)
            complex_.face_triangles.push_back({loop[0], loop[v - 1], loop[v]});
        face.triangle_count = static_cast<uint32_t>(loop.size()) - 2;
        complex_.loop_vertices.insert(complex_.loop_vertices.end(), loop.begin(), loop.end());
        complex_.faces.push_back(face);
    }

    const TriangleMesh& mesh_;
    std::vector<double> planes_;
    CellComplex complex_;
    std::map<std::array<uint32_t, 2>, uint32_t> edge_ids_;
    std::map<VertexKey, uint32_t> ids_;
};

}  // namespace

CellComplex makeSlabComplex(const TriangleMesh& mesh, const std::vector<double>& seed_x) {
    return SlabCutter(mesh, seed_x).cut();
}

}  // namespace demolish::test
