// How much of the sky each point sees past its neighbours: half-size, from depth alone, blurred along
// surfaces.
#pragma once
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class AmbientOcclusionPass {
  public:
    explicit AmbientOcclusionPass(const std::filesystem::path& shaders);
    /// `scene_radius` in m sets how far neighbours count. Result: r = visibility 0..1, g = linear depth, half
    /// size.
    const gl::Texture& run(const RenderTargets& targets, float scene_radius);

  private:
    void resize(int width, int height);
    gl::Program& reduceFor(int samples);
    std::filesystem::path shaders_;
    gl::Program reduce_single_, reduce_multi_, gather_, blur_;
    gl::Texture depth_, raw_, blurred_;
};

}  // namespace demolish::engine
