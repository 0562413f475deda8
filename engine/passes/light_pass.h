// From drawn materials to the display picture: sun, shadow, sky, occlusion, haze, tone curve, resolve, sRGB.
#pragma once
#include <filesystem>
#include <map>
#include <utility>

#include "engine/gl/program.h"
#include "engine/render/render_targets.h"
#include "engine/render/renderer.h"

namespace demolish::engine {

class LightPass {
  public:
    explicit LightPass(const std::filesystem::path& shaders);
    /// The shadow map and the noise volume are bound. `occlusion` may be null. Writes the RGBA8 texture
    /// `picture`.
    void run(const RenderTargets& targets, const gl::Texture* occlusion, RenderQuality quality,
             GLuint picture);

  private:
    gl::Program& programFor(const RenderTargets& targets, RenderQuality quality);
    std::filesystem::path shaders_;
    std::map<std::pair<int, RenderQuality>, gl::Program>
        programs_;  ///< by samples and quality, made when first needed
};

}  // namespace demolish::engine
