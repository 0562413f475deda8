// SPDX-License-Identifier: Apache-2.0
// Hairlines where bonds are broken inside one fragment.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/seen_cracks.h"
#include "engine/scene/surface_look.h"

namespace demolish::engine {

/// What the crack shaders know of a look.
void setCrackLook(gl::Program& program, const SurfaceLook& look);

class CrackPass {
  public:
    explicit CrackPass(const std::filesystem::path& shaders);
    /// As wide and as ragged as the look of their cells says; a line never gets thinner than about a pixel.
    /// The number of lines comes from the command buffer; `seen`: no more of them than these, null: all.
    void draw(const FractureMesh& mesh, const std::vector<SurfaceLook>& looks, const SeenCracks* seen);

  private:
    void drawLines(const FractureMesh& mesh, const SeenCracks* seen);
    gl::Program program_;
    gl::VertexArray layout_;
    gl::Buffer corners_;
};

}  // namespace demolish::engine
