// SPDX-License-Identifier: Apache-2.0
// Of a mesh's crack lines those that a picture may show, as SeenTriangles finds triangles: most lines of a
// broken body lie between pieces that have parted, and are drawn as nothing.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/frame_uniforms.h"

namespace demolish::engine {

class SeenCracks {
  public:
    /// `width`: of the widest line between two fragments, m. Lines are left out whose ends both show nothing:
    /// of no width, come apart by more than what CrackPass fades over, and, unless `frame` is null, turned
    /// away from its eye or too thin for its picture.
    void find(const FractureMesh& mesh, float width, const FrameUniforms* frame = nullptr);
    /// As StreamId::kCrackEdges.
    const gl::Buffer& lines() const { return lines_; }
    /// Of vertices 4 k + 0..3 of line k: two triangles each.
    const gl::Buffer& indices() const { return indices_; }
    uint32_t indexCount() const { return 6 * static_cast<uint32_t>(found_.size()); }

  private:
    struct Line {
        uint32_t edge, widths;
    };
    void upload();
    std::vector<Line> found_;
    gl::Buffer lines_, indices_;
    uint32_t indexed_ = 0;  ///< lines that `indices_` has
};

}  // namespace demolish::engine
