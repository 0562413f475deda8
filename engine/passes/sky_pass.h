// Fills what nothing covered.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"

namespace demolish::engine {

class SkyPass {
  public:
    explicit SkyPass(const std::filesystem::path& shaders);
    void draw() const;

  private:
    gl::Program program_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
