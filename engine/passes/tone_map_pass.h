// From light to display: occlusion, tone curve, resolve of the samples, sRGB.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class ToneMapPass {
  public:
    explicit ToneMapPass(const std::filesystem::path& shaders);
    /// `occlusion` may be null.
    void run(const RenderTargets& targets, const gl::Texture* occlusion);

  private:
    gl::Program& programFor(int samples);
    std::filesystem::path shaders_;
    gl::Program single_, double_, quadruple_;
};

}  // namespace demolish::engine
