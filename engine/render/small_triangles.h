// SPDX-License-Identifier: Apache-2.0
// A mesh's small triangles, rasterised on the CPU: which of them each sample of the picture shows, and how
// far from the sun the nearest lies at each texel of the shadow map. For drafts of software renderers, which
// shade a block of pixels for each triangle however few samples it covers. What is large is listed for them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/fracture_mesh.h"
#include "engine/render/mesh_lists.h"
#include "engine/render/small_raster.h"
#include "engine/render/surface_records.h"

namespace demolish::engine {

class SmallTriangles {
  public:
    static constexpr size_t kPictures = 3;  ///< the camera's, and both regions of the shadow map
    struct Target {
        glm::mat4 to_clip;  ///< from the world
        int width, height;  ///< px
        std::vector<glm::vec2> samples{{0.5f, 0.5f}};
    };

    /// The mesh's buffers are read where they lie, which waits for nothing in software. `slopes` and `steps`:
    /// as glPolygonOffset has them, of the shadow map.
    void find(const FractureMesh& mesh, const std::array<Target, kPictures>& targets,
              const FrameUniforms& frame, float slopes, float steps);
    /// As of the last find(): what the CPU has left to draw.
    const SeenList& large(size_t picture) const { return large_[picture]; }
    /// Of the camera's picture, sample after sample, row after row; named by their records.
    std::span<const NamedSample> named() const { return named_; }
    const SurfaceRecords& records() const { return records_; }
    /// Of a region of the shadow map, 0..1, row after row; 1 where there is nothing small.
    std::span<const float> depths(size_t region) const { return depths_[region]; }
    /// What of a picture shows small triangles.
    const PixelBox& touched(size_t picture) const { return touched_[picture]; }

  private:
    struct Found {
        std::array<std::vector<uint32_t>, kPictures> large;
        std::array<PixelBox, kPictures> touched;
    };
    struct Search;
    struct Listed;
    void clear(const std::array<Target, kPictures>& targets);
    void findIn(const Search& search, const Listed& listed, size_t first, Found& found);
    void putNamed(const FlatCorners& corners, float area, uint32_t name);
    void putDepth(const FlatCorners& corners, float area, size_t region, const Search& search);
    void gather(TriangleList SeenList::*side, const std::vector<Found>& stretches);

    std::array<PictureSamples, kPictures> samples_;
    std::vector<NamedSample> named_;
    SurfaceRecords records_;
    std::array<std::vector<float>, 2> depths_;
    std::array<PixelBox, kPictures> touched_{PixelBox::empty(), PixelBox::empty(), PixelBox::empty()};
    std::array<SeenList, kPictures> large_;
    std::vector<Found> outside_, inside_;
};

}  // namespace demolish::engine
