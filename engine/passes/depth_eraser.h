// SPDX-License-Identifier: Apache-2.0
// Empties a depth buffer where something was drawn last time and leaves the rest alone.
#pragma once
#include "engine/gl/framebuffer.h"
#include "engine/passes/touched_tiles.h"

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
    /// What the last remember() saw.
    const TouchedTiles& touched() const { return touched_; }

  private:
    TouchedTiles touched_;
    gl::Program erase_;
    bool known_ = false;
};

}  // namespace demolish::engine
