// SPDX-License-Identifier: Apache-2.0
// The floor plane y = 0 in the id picture; the light pass finds it without its being drawn.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class FloorPass {
  public:
    explicit FloorPass(const std::filesystem::path& shaders);
    void drawIds();

  private:
    gl::Program ids_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
