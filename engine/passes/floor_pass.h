// The floor plane y = 0.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/renderer.h"

namespace demolish::engine {

class FloorPass {
  public:
    explicit FloorPass(const std::filesystem::path& shaders);
    /// `tile_size` in m.
    void draw(float tile_size);
    void drawIds();

  private:
    gl::Program shaded_, ids_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
