// SPDX-License-Identifier: Apache-2.0
// Sparks over the finished picture: streaks that add light.
#pragma once
#include <filesystem>
#include <map>
#include <tuple>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class SparkPass {
  public:
    explicit SparkPass(const std::filesystem::path& shaders) : shaders_(shaders) {}
    /// As LightPass::showColliders().
    void showColliders(bool shows) { with_colliders_ = shows; }
    /// Over `framebuffer`. `nearest_depth`: as DustPass::draw().
    void draw(const FractureMesh& mesh, const RenderTargets& targets, const gl::Texture* nearest_depth,
              GLuint framebuffer);

  private:
    std::filesystem::path shaders_;
    /// By samples, fullness and whether there are colliders; made when first needed.
    std::map<std::tuple<int, bool, bool>, gl::Program> programs_;
    bool with_colliders_ = false;
    gl::VertexArray no_attributes_;
};

/// What shaders/common/solid.glsl asks for.
std::string solidDefines(const RenderTargets& targets, bool full, bool with_colliders);

}  // namespace demolish::engine
