// SPDX-License-Identifier: Apache-2.0
// Light of the sun that transparent bodies gather on the floor: its rays are bent where they enter and leave,
// and added up where they arrive.
#pragma once
#include <filesystem>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"

namespace demolish::engine {

class CausticsPass {
  public:
    static constexpr int kTexels = 512;  ///< along the near region of the sun's map

    /// Throws GlError.
    explicit CausticsPass(const std::filesystem::path& shaders);
    /// From the sums of the sun's light (shaders/common/glass_tint.glsl), with mip maps, and the ends of its
    /// way (shaders/common/glass_ends.glsl), both of the near region. The frame's uniforms are bound. The
    /// index of refraction, the absorption and the place of the floor are theirs.
    void cast(const gl::Texture& sums, const gl::Texture& ends);
    /// RGBA16F: light on the floor, times what falls there without such bodies.
    const gl::Texture& light() const { return light_; }

  private:
    gl::Program empty_, cast_, show_;
    gl::Buffer steps_;
    gl::Texture light_;
};

}  // namespace demolish::engine
