// Draws the body: outside and broken faces, each with its material.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/passes/body_geometry.h"
#include "engine/render/renderer.h"

namespace demolish::engine {

class SurfacePass {
  public:
    explicit SurfacePass(const std::filesystem::path& shaders);
    void draw(BodyGeometry& body, const BodyTriangles& triangles, const SurfaceLook& look);

  private:
    gl::Program exterior_, interior_;
};

}  // namespace demolish::engine
