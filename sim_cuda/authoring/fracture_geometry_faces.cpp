// SPDX-License-Identifier: Apache-2.0
// Interior faces as triangles fine enough to be bent: split edges, and a centre vertex wherever the face is
// star-shaped.
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/fracture_geometry_parts.h"

namespace demolish {
namespace {

constexpr size_t kFacesPerChunk = 256;             // fixed, so that the result does not depend on the threads
constexpr size_t kMostTrianglesOfRecord = 21'845;  // their vertices, at most three each, fit 16-bit indices

struct RingVertex {
    uint32_t pool;
    Double3 position;
};
using PoolTriangle = std::array<uint32_t, 3>;

/// What a run of faces gives. Centres are numbered from `first_centre` on within the chunk.
struct FaceChunk {
    std::vector<InteriorFace> faces;
    std::vector<uint32_t> vertices;
    std::vector<uint16_t> indices;
    std::vector<Double3> centres;
};

class FaceTessellator {
  public:
    FaceTessellator(const CellComplex& complex, const SplitEdges& split,
                    const std::vector<uint32_t>& pool_of_vertex, uint32_t first_split, uint32_t first_centre,
                    FaceChunk& chunk)
        : complex_(complex),
          split_(split),
          pool_of_vertex_(pool_of_vertex),
          first_split_(first_split),
          first_centre_(first_centre),
          chunk_(chunk) {}

    void add(const ComplexFace& face, uint32_t bond) {
        makeRing(face);
        if (face.loop_count == 1 && ring_.size() == 3)
            triangles_.assign({{ring_[0].pool, ring_[1].pool, ring_[2].pool}});
        else if (face.loop_count == 1 && isStarShaped(face))
            fan(face.centroid);
        else
            refine(face);
        for (size_t first = 0; first < triangles_.size(); first += kMostTrianglesOfRecord)
            addRecord(face, bond, first, std::min(first + kMostTrianglesOfRecord, triangles_.size()));
    }

  private:
    RingVertex vertexAt(uint32_t v) const { return {pool_of_vertex_[v], complex_.vertices[v].position}; }

    /// u and the split points after it on the way to v.
    void appendEdge(uint32_t u, uint32_t v, std::vector<RingVertex>& ring) const {
        ring.push_back(vertexAt(u));
        const SplitEdges::Edge* edge = split_.find(u, v);
        if (edge == nullptr) return;
        for (uint32_t s = 0; s + 1 < edge->parts; ++s) {
            const uint32_t point = edge->first_split + (u < v ? s : edge->parts - 2 - s);
            ring.push_back({first_split_ + point, split_.points[point]});
        }
    }

    void makeRing(const ComplexFace& face) {
        ring_.clear();
        const uint32_t begin = complex_.loop_start[face.first_loop],
                       end = complex_.loop_start[face.first_loop + 1];
        for (uint32_t at = begin; at < end; ++at)
            appendEdge(complex_.loop_vertices[at], complex_.loop_vertices[at + 1 < end ? at + 1 : begin],
                       ring_);
    }

    /// Every edge of the outer loop turns counter-clockwise round the centroid.
    bool isStarShaped(const ComplexFace& face) const {
        Double3 normal;  // of the loop itself: a face of a moved part lies on no bisector of its cells
        Double3 from = ring_.back().position - face.centroid;
        for (const RingVertex& vertex : ring_) {
            const Double3 to = vertex.position - face.centroid;
            normal += cross(from, to);
            from = to;
        }
        for (const RingVertex& vertex : ring_) {
            const Double3 to = vertex.position - face.centroid;
            const double turn = dot(cross(from, to), normal);
            if (!(turn > 1e-9 * length(normal) * length(from) * length(to))) return false;
            from = to;
        }
        return true;
    }

    uint32_t addCentre(const Double3& position) {
        chunk_.centres.push_back(position);
        return first_centre_ + static_cast<uint32_t>(chunk_.centres.size()) - 1;
    }

    void fan(const Double3& centre_position) {
        const uint32_t centre = addCentre(centre_position);
        triangles_.clear();
        appendFan(ring_, centre);
    }

    void appendFan(const std::vector<RingVertex>& ring, uint32_t centre) {
        for (size_t at = 0; at < ring.size(); ++at)
            triangles_.push_back({ring[at].pool, ring[at + 1 < ring.size() ? at + 1 : 0].pool, centre});
    }

    /// The complex's triangulation with the split points put in. Diagonals are never split: they are the
    /// face's own.
    void refine(const ComplexFace& face) {
        triangles_.clear();
        for (uint32_t t = face.first_triangle; t < face.first_triangle + face.triangle_count; ++t) {
            const auto& [a, b, c] = complex_.face_triangles[t];
            refined_.clear();
            appendEdge(a, b, refined_);
            const size_t corner_b = refined_.size();
            appendEdge(b, c, refined_);
            const size_t corner_c = refined_.size();
            appendEdge(c, a, refined_);
            const bool cut_ab = corner_b > 1, cut_bc = corner_c > corner_b + 1,
                       cut_ca = refined_.size() > corner_c + 1;
            if (cut_ab + cut_bc + cut_ca > 1)
                appendFan(refined_, addCentre((refined_[0].position + refined_[corner_b].position +
                                               refined_[corner_c].position) *
                                              (1.0 / 3)));
            else
                fanFromCorner(cut_bc ? 0 : (cut_ca ? corner_b : corner_c));
        }
    }

    /// At most the edge opposite the apex is cut.
    void fanFromCorner(size_t apex) {
        const size_t n = refined_.size();
        for (size_t step = 1; step + 1 < n; ++step)
            triangles_.push_back({refined_[apex].pool, refined_[(apex + step) % n].pool,
                                  refined_[(apex + step + 1) % n].pool});
    }

    void addRecord(const ComplexFace& face, uint32_t bond, size_t first, size_t end) {
        locals_.clear();
        for (size_t t = first; t < end; ++t)
            locals_.insert(locals_.end(), triangles_[t].begin(), triangles_[t].end());
        std::sort(locals_.begin(), locals_.end());
        locals_.erase(std::unique(locals_.begin(), locals_.end()), locals_.end());
        chunk_.faces.push_back({face.cell_a, face.cell_b, static_cast<uint32_t>(chunk_.vertices.size()),
                                static_cast<uint32_t>(locals_.size()),
                                static_cast<uint32_t>(chunk_.indices.size()),
                                static_cast<uint32_t>(3 * (end - first)), bond});
        chunk_.vertices.insert(chunk_.vertices.end(), locals_.begin(), locals_.end());
        for (size_t t = first; t < end; ++t)
            for (const uint32_t pool : triangles_[t])
                chunk_.indices.push_back(static_cast<uint16_t>(
                    std::lower_bound(locals_.begin(), locals_.end(), pool) - locals_.begin()));
    }

    const CellComplex& complex_;
    const SplitEdges& split_;
    const std::vector<uint32_t>& pool_of_vertex_;
    uint32_t first_split_, first_centre_;
    FaceChunk& chunk_;
    std::vector<RingVertex> ring_, refined_;
    std::vector<PoolTriangle> triangles_;
    std::vector<uint32_t> locals_;
};

/// Numbers the complex's vertices that lie on faces, in the complex's order, and starts the pool with them.
std::vector<uint32_t> poolOfVertices(const CellComplex& complex, FractureGeometry& geometry) {
    std::vector<uint32_t> pool(complex.vertices.size(), kNoPool);
    for (const uint32_t v : complex.loop_vertices) pool[v] = 0;
    for (size_t v = 0; v < pool.size(); ++v) {
        if (pool[v] == kNoPool) continue;
        pool[v] = static_cast<uint32_t>(geometry.pool.size());
        const Double3& p = complex.vertices[v].position;
        geometry.pool.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        geometry.pool_on_surface.push_back(complex.vertices[v].key.kind != VertexKind::kInterior);
    }
    return pool;
}

void appendInside(const std::vector<Double3>& points, FractureGeometry& geometry) {
    for (const Double3& p : points)
        geometry.pool.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    geometry.pool_on_surface.resize(geometry.pool.size(), 0);
}

void joinChunks(const std::vector<FaceChunk>& chunks, uint32_t first_centre, FractureGeometry& geometry) {
    struct Offsets {
        size_t face = 0, vertex = 0, index = 0, centre = 0;
    };
    std::vector<Offsets> offsets(chunks.size() + 1);
    for (size_t c = 0; c < chunks.size(); ++c)
        offsets[c + 1] = {
            offsets[c].face + chunks[c].faces.size(), offsets[c].vertex + chunks[c].vertices.size(),
            offsets[c].index + chunks[c].indices.size(), offsets[c].centre + chunks[c].centres.size()};
    geometry.faces.resize(offsets.back().face);
    geometry.face_vertices.resize(offsets.back().vertex);
    geometry.face_indices.resize(offsets.back().index);
    tbb::parallel_for(size_t{0}, chunks.size(), [&](size_t c) {
        const FaceChunk& chunk = chunks[c];
        const Offsets& to = offsets[c];
        std::copy(chunk.indices.begin(), chunk.indices.end(), geometry.face_indices.begin() + to.index);
        for (size_t f = 0; f < chunk.faces.size(); ++f) {
            InteriorFace face = chunk.faces[f];
            face.first_vertex += static_cast<uint32_t>(to.vertex);
            face.first_index += static_cast<uint32_t>(to.index);
            geometry.faces[to.face + f] = face;
        }
        for (size_t v = 0; v < chunk.vertices.size(); ++v) {
            const uint32_t pool = chunk.vertices[v];
            geometry.face_vertices[to.vertex + v] =
                pool < first_centre ? pool : pool + static_cast<uint32_t>(to.centre);
        }
    });
    for (const FaceChunk& chunk : chunks) appendInside(chunk.centres, geometry);
}

}  // namespace

std::vector<uint32_t> tessellateFaces(const CellComplex& complex, const SplitEdges& split,
                                      const BondLookup& bonds, FractureGeometry& geometry) {
    std::vector<uint32_t> pool_of_vertex = poolOfVertices(complex, geometry);
    const auto first_split = static_cast<uint32_t>(geometry.pool.size());
    appendInside(split.points, geometry);
    const auto first_centre = static_cast<uint32_t>(geometry.pool.size());
    std::vector<FaceChunk> chunks((complex.faces.size() + kFacesPerChunk - 1) / kFacesPerChunk);
    tbb::parallel_for(size_t{0}, chunks.size(), [&](size_t c) {
        FaceTessellator tessellator(complex, split, pool_of_vertex, first_split, first_centre, chunks[c]);
        const size_t end = std::min((c + 1) * kFacesPerChunk, complex.faces.size());
        for (size_t f = c * kFacesPerChunk; f < end; ++f) {
            const ComplexFace& face = complex.faces[f];
            tessellator.add(face, bonds.find(face.cell_a, face.cell_b));
        }
    });
    joinChunks(chunks, first_centre, geometry);
    return pool_of_vertex;
}

}  // namespace demolish
