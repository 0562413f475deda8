// SPDX-License-Identifier: Apache-2.0
// Of a mesh's triangles those that a picture may show, found on the CPU before they are drawn. For software
// renderers: they spend most of their time on triangles of which nothing is seen.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/sample_grid.h"

namespace demolish::engine {

/// Indices of triangles, in the order in which the mesh has them.
struct TriangleList {
    gl::Buffer indices;
    uint32_t count = 0;  ///< indices, three a triangle
};

struct SeenList {
    TriangleList exterior, interior;
};

class SeenTriangles {
  public:
    static constexpr size_t kMostPictures = 3;
    /// Indices that one stretch of triangles leaves, for each picture.
    using Found = std::vector<std::vector<uint32_t>>;

    /// Fills a list for each picture, of which there are kMostPictures at most. The mesh's buffers are read
    /// where they lie, which waits for nothing in software. `both_sides`: of the outside, backs are seen,
    /// too.
    void find(const FractureMesh& mesh, std::span<const SampleGrid> pictures, bool both_sides);
    /// As of the last find().
    const SeenList& in(size_t picture) const { return lists_[picture]; }

  private:
    void collect(TriangleList SeenList::*side);
    std::vector<SeenList> lists_;
    std::vector<Found> stretches_;
};

}  // namespace demolish::engine
