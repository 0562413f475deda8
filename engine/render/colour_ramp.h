// SPDX-License-Identifier: Apache-2.0
// The scale of the particle view as a small picture, for whoever has to say what its colours mean.
#pragma once
#include <filesystem>

#include "engine/gl/texture.h"

namespace demolish::engine {

class ColourRamp {
  public:
    /// Draws it, once; the GL context is current. Throws gl::GlError.
    explicit ColourRamp(const std::filesystem::path& shader_folder);
    /// RGBA8, a row: 0 on the left, 1 on the right.
    const gl::Texture& texture() const { return texture_; }

  private:
    gl::Texture texture_;
};

}  // namespace demolish::engine
