// SPDX-License-Identifier: Apache-2.0
// The volumes that materials are shaded from: noise, and pebbles and crystals.
#pragma once
#include "engine/gl/texture.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class ShadingVolumes {
  public:
    ShadingVolumes();
    /// Those that a picture needs, as shaders/common/noise.glsl and solid_texture.glsl have them.
    void bind(const FrameView& view);
    static void unbind();

  private:
    gl::Texture noise_, cells_;  ///< the second: made when first needed
    gl::Sampler draft_noise_;    ///< half the texels: software renderers feel it in every pixel
};

}  // namespace demolish::engine
