// SPDX-License-Identifier: Apache-2.0
// What of a mesh a frame may show, for software renderers: on the picture, in both regions of the shadow map,
// and of its cracks.
#pragma once
#include <cstdint>

#include "engine/render/frame_uniforms.h"
#include "engine/render/render_targets.h"
#include "engine/render/seen_cracks.h"
#include "engine/render/seen_triangles.h"
#include "engine/render/small_triangles.h"

namespace demolish::engine {

class SeenMesh {
  public:
    /// Nothing is done where mesh and pictures are those of the last call. `shadow_texels` along each side of
    /// a region; `both_sides`: of the outside, backs are seen, too.
    /// `near`: of the mesh, null: none.
    void find(const FractureMesh& mesh, const NearFaces* near, const FrameView& view,
              const FrameUniforms& frame, const RenderTargets& targets, int shadow_texels,
              const SeenTriangles::Wanted& wanted);
    const SeenList& onPicture() const { return in(0); }
    /// `region`: 0 near, 1 far.
    const SeenList& inShadow(int region) const { return in(static_cast<size_t>(region) + 1); }
    /// What is shown beside these lists; null: nothing.
    const SmallTriangles* small() const { return key_.names_small ? &small_ : nullptr; }
    const SeenCracks& cracks() const { return cracks_; }

  private:
    struct Key {
        uint64_t mesh_version = 0, near_version = 0;
        glm::mat4 view_projection{0}, light_matrix[2]{glm::mat4(0), glm::mat4(0)};
        int width = 0, height = 0, samples = 0, shadow_texels = 0;
        float crack_width = -1;
        SeenTriangles::Wanted wanted;
        bool names_small = false;
        bool operator==(const Key&) const = default;
    };
    const SeenList& in(size_t picture) const {
        return key_.names_small ? small_.large(picture) : triangles_.in(picture);
    }
    Key key_;
    SeenTriangles triangles_;
    SmallTriangles small_;
    SeenCracks cracks_;
};

}  // namespace demolish::engine
