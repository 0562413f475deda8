// SPDX-License-Identifier: Apache-2.0
// Light that bodies send out of themselves, where they are what a sample shows: drawn over the finished
// depth.
#pragma once
#include <filesystem>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/passes/body_geometry.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class GlowPass {
  public:
    explicit GlowPass(const std::filesystem::path& shaders) : shaders_(shaders) {}
    /// The mesh has looks that glow, and they are bound. Depth tests are on and reversed; what is drawn next
    /// goes into the targets again.
    void draw(BodyGeometry& body, const FractureMesh& mesh, const RenderTargets& targets);
    /// Unit 19, for shaders/common/drawn_sample.glsl.
    void bind() const;

  private:
    std::filesystem::path shaders_;
    gl::Program program_;  ///< made when first needed
    gl::Texture glow_;
    gl::Framebuffer framebuffer_;
    GLuint depth_ = 0;  ///< texture that the framebuffer was made with
    int samples_ = 0;
};

}  // namespace demolish::engine
