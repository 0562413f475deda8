// SPDX-License-Identifier: Apache-2.0
// Sparks over the finished picture: streaks that add light.
#pragma once
#include <filesystem>
#include <map>
#include <utility>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/passes/picture_kind.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class SparkPass {
  public:
    explicit SparkPass(const std::filesystem::path& shaders);
    /// For the frames to come.
    void prepare(const PictureKind& kind, const Opening& opening) {
        kind_ = kind;
        opening_ = opening;
    }
    /// Over `framebuffer`. `nearest_depth`: as DustPass::draw().
    void draw(const FractureMesh& mesh, const RenderTargets& targets, const gl::Texture* nearest_depth,
              GLuint framebuffer);

  private:
    /// Finds the grains that glow. Returns of how many groups they are.
    GLsizei list(const FractureMesh& mesh);
    std::filesystem::path shaders_;
    gl::Program list_;
    gl::Buffer ids_, commands_;
    std::map<std::pair<bool, PictureKind>, gl::Program> programs_;  ///< by fullness; made when first needed
    PictureKind kind_;
    Opening opening_;
    gl::VertexArray layout_;
};

}  // namespace demolish::engine
