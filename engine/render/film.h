// SPDX-License-Identifier: Apache-2.0
// Averages pictures of linear light and develops the mean: motion blur, depth of field, fine edges.
#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"
#include "engine/scene/lighting.h"

namespace demolish::engine {

class Film {
  public:
    explicit Film(const std::filesystem::path& shader_folder);
    /// Forgets all pictures. Sizes in px. Throws gl::GlError.
    void begin(int width, int height);
    /// What Renderer::draw() is to draw the next picture into, of a view with `radiance`.
    unsigned framebuffer() const { return picture_target_.id(); }
    void add();  ///< what was drawn there
    int pictures() const { return pictures_; }
    /// The mean of at least one picture, by the light's exposure and tone curve, into an RGBA8 framebuffer of
    /// the same size.
    void develop(const Lighting& light, unsigned framebuffer);

  private:
    void cover(unsigned framebuffer);
    std::filesystem::path shaders_;
    gl::Program add_;
    std::map<ToneCurve, gl::Program> develop_;  ///< made when first needed
    gl::Texture picture_, sum_;
    gl::Framebuffer picture_target_, sum_target_;
    gl::VertexArray no_attributes_;
    int width_ = 0, height_ = 0, pictures_ = 0;
};

}  // namespace demolish::engine
