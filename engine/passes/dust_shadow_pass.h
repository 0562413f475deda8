// SPDX-License-Identifier: Apache-2.0
// What dust leaves of the sun: its puffs added up as the sun sees them.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/render/fracture_mesh.h"

namespace demolish::engine {

class DustShadowPass {
  public:
    /// Throws GlError.
    explicit DustShadowPass(const std::filesystem::path& shaders);
    /// Of this frame, for all that asks the shadow map, in whose near region it lies. `mesh` null: no dust,
    /// as in drafts. Binds unit 11, as shaders/common/dust_shadow.glsl has it.
    void cast(const FractureMesh* mesh);

  private:
    gl::Program cast_, show_;
    gl::Texture nothing_;
    gl::Texture sums_, shadow_;  ///< made when dust is first seen; the sums are 0 between two frames
};

}  // namespace demolish::engine
