// SPDX-License-Identifier: Apache-2.0
// From drawn materials to the display picture: sun, shadow, sky, occlusion, haze, tone curve, resolve, sRGB.
#pragma once
#include <filesystem>
#include <map>
#include <tuple>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/passes/picture_kind.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/render_targets.h"
#include "engine/render/surroundings_textures.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class LightPass {
  public:
    explicit LightPass(const std::filesystem::path& shaders);
    /// For the frames to come; `with_looks`: of models. Binds what surrounds them, for all passes.
    void prepare(const FrameView& view, const PictureKind& kind, bool with_looks);
    /// The shadow map and the noise volume are bound, here and in all. Writes the texture `picture`, of RGBA8
    /// or, for radiance, RGBA16F.
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
    GLenum pictureFormat() const { return kind_.radiance ? GL_RGBA16F : GL_RGBA8; }
    std::filesystem::path shaders_;
    std::map<std::tuple<Way, SolidTexture, PictureKind>, gl::Program> programs_;  ///< made when first needed
    SolidTexture texture_ = SolidTexture::kNone;                                  ///< of the frames to come
    bool with_looks_ = false;                                                     ///< likewise
    PictureKind kind_;                                                            ///< of the frames to come
    SurroundingsTextures surroundings_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
