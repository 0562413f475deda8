// SPDX-License-Identifier: Apache-2.0
// Draws grains of grit among the materials and into the shadow map.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class GritPass {
  public:
    explicit GritPass(const std::filesystem::path& shaders);
    void draw(const FractureMesh& mesh, const SurfaceLook& look);
    /// `region` of the shadow map that is being drawn.
    void drawShadows(const FractureMesh& mesh, int region);

  private:
    void run(const gl::Program& program, const FractureMesh& mesh);
    gl::Program shaded_, shadows_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
