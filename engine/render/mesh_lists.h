// SPDX-License-Identifier: Apache-2.0
// A mesh's lists of triangles, as the CPU reads and makes them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/mesh_motion.h"

namespace demolish::engine {

/// Triangles of two buffers, read where they lie for as long as this lives.
class ListReading {
  public:
    ListReading(const gl::Buffer& vertices, const gl::Buffer& indices, size_t first, size_t count)
        : vertices_(vertices), indices_(indices), first_(first), count_(count) {}
    std::span<const MeshVertex> vertices() const { return vertices_.as<MeshVertex>(); }
    std::span<const uint32_t> indices() const {
        const auto all = indices_.as<uint32_t>();
        return all.subspan(first_, std::min(count_, all.size() - first_));
    }

  private:
    gl::BufferReading vertices_, indices_;
    size_t first_, count_;
};

inline ListReading outsideOf(const FractureMesh& mesh) {
    return {mesh.exteriorVertices(), mesh.stream(StreamId::kExteriorIndices), 0,
            commandOf(mesh, kExteriorCommand).count};
}
inline ListReading insideOf(const FractureMesh& mesh) {
    return {mesh.stream(StreamId::kInteriorVertices), mesh.stream(StreamId::kInteriorIndices), 0,
            commandOf(mesh, kInteriorCommand).count};
}

/// Indices of triangles, in the order in which the mesh has them.
struct TriangleList {
    gl::Buffer indices;
    uint32_t count = 0;  ///< indices, three a triangle

    /// One part after the other, each a std::vector<uint32_t> that `partOf` picks from one of `stretches`.
    template <class Stretch, class PartOf>
    void fill(const std::vector<Stretch>& stretches, const PartOf& partOf) {
        constexpr size_t kLeastBytes = 64;
        size_t total = 0;
        for (const Stretch& stretch : stretches) total += partOf(stretch).size();
        count = static_cast<uint32_t>(total);
        if (indices.size() == 0) indices = gl::Buffer::resizable(kLeastBytes, GL_STREAM_DRAW);
        indices.resize(std::max(kLeastBytes, total * sizeof(uint32_t)));
        size_t at = 0;
        for (const Stretch& stretch : stretches) {
            const auto bytes = std::as_bytes(std::span(partOf(stretch)));
            indices.upload(bytes, at);
            at += bytes.size();
        }
    }
};

/// What of a mesh is drawn.
struct SeenList {
    TriangleList exterior, interior, near;
};

}  // namespace demolish::engine
