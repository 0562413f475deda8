// SPDX-License-Identifier: Apache-2.0
// Empties a depth buffer where something was drawn last time and leaves the rest alone.
#pragma once
#include <filesystem>

#include "engine/gl/buffer.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"

namespace demolish::engine {

/// Of one depth texture. A frame calls erase(), draws, and calls remember().
class DepthEraser {
  public:
    /// `empty_depth`: 0 (reversed) or 1.
    DepthEraser(const std::filesystem::path& shaders, float empty_depth);

    /// The texture is a new one, or was drawn into without remember(): the next erase() clears all of it.
    void forget() { known_ = false; }
    /// Leaves a depth-only framebuffer of the texture bound, its viewport set, depth test on, clip range 0..1
    /// expected. The caller sets the depth function afterwards.
    void erase(const gl::Framebuffer& depth_only, const gl::Texture& depth);
    /// Notes what has been drawn since; `samples` of the texture.
    void remember(const gl::Texture& depth, int samples);

  private:
    void prepareList(int tiles);
    std::filesystem::path shaders_;
    gl::Program find_single_, find_multi_, erase_;
    gl::VertexArray no_attributes_;
    gl::Buffer list_;
    float empty_depth_;
    int capacity_ = 0;
    bool known_ = false;
};

}  // namespace demolish::engine
