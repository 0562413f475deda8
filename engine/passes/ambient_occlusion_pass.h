// SPDX-License-Identifier: Apache-2.0
// How much of the sky each point sees past its neighbours: half-size, from depth alone, blurred along
// surfaces.
#pragma once
#include <filesystem>
#include <map>
#include <tuple>

#include "engine/gl/program.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class AmbientOcclusionPass {
  public:
    explicit AmbientOcclusionPass(const std::filesystem::path& shaders);
    /// `scene_radius` in m sets how far neighbours count; `found`: depth is what ComputedRaster found and has
    /// bound. Result: r = visibility 0..1, g = linear depth, half size.
    const gl::Texture& run(const RenderTargets& targets, float scene_radius, bool found);
    /// As the last run() found it: m along the view axis, half size, the nearest of four pixels, the floor
    /// and colliders included.
    const gl::Texture& nearestDepth() const { return depth_; }
    /// Makes the shader that run() needs with `found`. Throws GlError.
    void prepareFound(const RenderTargets& targets) { reduceFor(targets.samples, true); }
    /// As LightPass::showColliders().
    void showColliders(bool shows) { with_colliders_ = shows; }

  private:
    void resize(int width, int height);
    gl::Program& reduceFor(int samples, bool found);
    std::filesystem::path shaders_;
    gl::Program gather_, blur_;
    /// By samples, `found` and whether there are colliders; made when first needed.
    std::map<std::tuple<int, bool, bool>, gl::Program> reduce_;
    bool with_colliders_ = false;
    gl::Texture depth_, raw_, blurred_;
};

}  // namespace demolish::engine
