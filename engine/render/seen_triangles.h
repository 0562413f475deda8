// SPDX-License-Identifier: Apache-2.0
// Of a mesh's triangles those that a picture may show, found on the CPU before they are drawn. For software
// renderers: they spend most of their time on triangles of which nothing is seen.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/fracture_mesh.h"
#include "engine/render/hidden_triangles.h"
#include "engine/render/mesh_lists.h"
#include "engine/render/near_faces.h"
#include "engine/render/sample_grid.h"

namespace demolish::engine {

class SeenTriangles {
  public:
    static constexpr size_t kMostPictures = 3;
    struct Wanted {
        bool both_sides = false;  ///< of the outside, backs are seen, too
        bool hidden = true;       ///< of the first picture, also what lies behind other triangles
        bool operator==(const Wanted&) const = default;
    };

    /// Fills a list for each picture, of which there are kMostPictures at most. The mesh's buffers are read
    /// where they lie, which waits for nothing in software.
    /// `near`: shown in place of a part of them; null: nothing.
    void find(const FractureMesh& mesh, const NearFaces* near, std::span<const SampleGrid> pictures,
              const Wanted& wanted);
    /// As of the last find().
    const SeenList& in(size_t picture) const { return lists_[picture]; }

  private:
    /// What one stretch of triangles leaves.
    struct Found {
        Candidates candidates;                       ///< of the first picture, where hidden ones are left out
        std::vector<std::vector<uint32_t>> indices;  ///< for each picture
    };
    struct Listed;
    struct Search;
    void findIn(const Search& search, const Listed& listed, size_t first, Found& found);
    void collect(TriangleList SeenList::*side, const std::vector<Found>& stretches);
    std::vector<SeenList> lists_;
    std::vector<Found> outside_, inside_, near_;
    NearestSurely nearest_;
};

}  // namespace demolish::engine
