// SPDX-License-Identifier: Apache-2.0
// Transparent bodies: their faces are found along each ray, drawn layer by layer or computed at once, then
// each ray walks through them. No order of drawing is needed. Everything opaque is lit before, as light, into
// scene().
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/passes/body_geometry.h"
#include "engine/passes/caustics_pass.h"
#include "engine/passes/depth_eraser.h"
#include "engine/passes/glass_raster.h"
#include "engine/passes/picture_kind.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class GlassPass {
  public:
    /// `task_room`: as TriangleRaster's.
    GlassPass(const std::filesystem::path& shaders, size_t task_room);
    /// Can faces be computed for these targets? Makes what that takes. Throws GlError where a driver refuses
    /// it.
    bool readyToFind(const FractureMesh& mesh, const RenderTargets& targets);
    /// Makes or takes again what the sun loses in the mesh, and binds it (unit 14), as
    /// shaders/common/glass_tint.glsl has it, and but for drafts what they bend onto the floor (unit 20).
    /// `light_matrix`: of the near region. `finds`: readyToFind().
    void castShadow(BodyGeometry& body, const FractureMesh& mesh, const glm::mat4& light_matrix,
                    const FrameView& view, bool finds);
    /// Into which the light of all that is opaque goes, RGBA16F of the targets' size.
    GLuint scene(const RenderTargets& targets);
    /// Depth of what is opaque is the targets'. The depth range is 0..1, reversed, and stays so.
    void peel(BodyGeometry& body, const FractureMesh& mesh, const FrameView& view,
              const RenderTargets& targets);
    /// The same by computing, where readyToFind().
    void find(const FractureMesh& mesh, const FrameView& view, const RenderTargets& targets);
    /// The finished picture into `framebuffer`, from what peel() has drawn: rays walk where glass is, since
    /// a software renderer goes through the walk of every pixel that it is given. Bound are the shadow map,
    /// the noise volume, the surroundings and the sums of dust.
    void walk(const RenderTargets& targets, const FrameView& view, PictureKind kind, GLuint framebuffer);
    /// The same by computing: on data-centre GPUs only few multiprocessors draw, but all of them compute.
    /// `found`: the mesh of which find() has found the faces, null after peel().
    void computeWalk(const FractureMesh* found, const RenderTargets& targets, const FrameView& view,
                     PictureKind kind, GLuint framebuffer);

  private:
    static constexpr int kLayers = 4;
    struct Layer {
        gl::Texture texture;  ///< RG32UI, shaders/common/glass_layer.glsl
        gl::Framebuffer framebuffer;
    };
    struct PeelPrograms {
        gl::Program exterior, interior;
    };
    struct ShadowKey {
        uint64_t mesh_version;
        glm::mat4 light_matrix;
        glm::vec4 bends;  ///< absorption, refraction index
        float frost;
        bool bent;  ///< with caustics
        bool operator==(const ShadowKey&) const = default;
    };
    /// How the walk runs, and on what.
    enum class Walk { kDrawn, kComputed, kOverFound };
    void makeShadowTargets(bool draft);
    void drawShadow(BodyGeometry& body, const FractureMesh& mesh, uint32_t hidden, float scattered,
                    bool with_ends);
    void fit(const RenderTargets& targets);
    void fitLayers(const RenderTargets& targets);
    void clearLayers();
    void peelLayer(size_t k, PeelPrograms& programs, BodyGeometry& body, const FractureMesh& mesh);
    PeelPrograms& peelFor(const RenderTargets& targets);
    gl::Program& walkFor(const RenderTargets& targets, PictureKind kind, Walk how);
    /// Of what no glass is before.
    gl::Program& behindFor(const PictureKind& kind);
    void bindLayers() const;
    void bindWalk(gl::Program& program, const RenderTargets& targets, const FrameView& view);

    std::filesystem::path shaders_;
    size_t task_room_;
    std::optional<GlassRaster> raster_;                 ///< made when first needed
    std::map<std::pair<int, int>, PeelPrograms> peel_;  ///< by samples, and layer texels across a pixel
    std::map<std::tuple<PictureKind, int, Walk>, gl::Program> walk_;  ///< by layer texels across
    std::map<PictureKind, gl::Program> behind_;
    gl::Program shadow_;
    gl::Program clear_;
    DepthEraser eraser_;                    ///< of depth_
    std::optional<CausticsPass> caustics_;  ///< made when first needed, as is shadow_ends_
    gl::Texture shadow_sums_, shadow_ends_, scene_, depth_;
    gl::Framebuffer shadow_target_, ends_target_, scene_target_, depth_only_;
    std::array<Layer, kLayers> layers_;
    std::optional<ShadowKey> shadow_key_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
