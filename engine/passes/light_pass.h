// SPDX-License-Identifier: Apache-2.0
// From drawn materials to the display picture: sun, shadow, sky, occlusion, haze, tone curve, resolve, sRGB.
#pragma once
#include <filesystem>
#include <map>
#include <tuple>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/render_targets.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class LightPass {
  public:
    explicit LightPass(const std::filesystem::path& shaders);
    /// Whether the frames to come show colliders, which are bound then: without them shaders are shorter.
    void showColliders(bool shows) { with_colliders_ = shows; }
    /// The shadow map and the noise volume are bound, here and in all. Writes the RGBA8 texture `picture`.
    void compute(const RenderTargets& targets, const gl::Texture& occlusion, GLuint picture);
    /// The same from what ComputedRaster found and has bound.
    void computeFound(const RenderTargets& targets, const gl::Texture& occlusion, const SurfaceLook& look,
                      GLuint picture);
    /// Makes the shaders of computeFound(). Throws GlError.
    void prepareFound(const RenderTargets& targets) {
        programFor(targets, Way::kEmpty);
        programFor(targets, Way::kFound);
    }
    /// The same for drafts, which have no occlusion, into `framebuffer` (0: the window), drawn: llvmpipe
    /// takes longer to store a pixel from a compute shader than to light it.
    void draw(const RenderTargets& targets, GLuint framebuffer);

  private:
    enum class Way { kDrawn, kComputed, kEmpty, kFound };
    gl::Program& programFor(const RenderTargets& targets, Way way);
    static void bindPicture(const gl::Texture& occlusion, GLuint picture);
    std::filesystem::path shaders_;
    /// By samples, way and whether there are colliders; made when first needed.
    std::map<std::tuple<int, Way, bool>, gl::Program> programs_;
    bool with_colliders_ = false;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
