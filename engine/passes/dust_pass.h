// SPDX-License-Identifier: Apache-2.0
// Dust before what the picture shows: puffs added up at a part of its size, softened at what they meet, lit
// and shadowed. The light pass lays the sums over what it lights.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "engine/gl/buffer.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/passes/picture_kind.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/render_targets.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class DustPass {
  public:
    explicit DustPass(const std::filesystem::path& shaders);
    /// For the frames to come. `computes`: the sums of full pictures are computed rather than drawn. Throws
    /// gl::GlError where the driver refuses to.
    void prepare(const PictureKind& kind, const RenderTargets& targets, bool computes);
    /// Binds the sums of this frame, as shaders/common/dust_over.glsl has it (`mesh` null: none). The shadow
    /// map (unit 1), DustShadowPass, the surroundings and the noise volume are bound. `nearest_depth`:
    /// AmbientOcclusionPass::nearestDepth() of this frame; null, of drafts: the depth of `targets` counts.
    void addUp(const FractureMesh* mesh, const FrameView& view, const RenderTargets& targets,
               const gl::Texture* nearest_depth);

  private:
    struct Sums {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    /// Those that compute.
    struct Tiles {
        gl::Program see, list, sum;
    };
    void fit(int width, int height);
    gl::Program& puffsFor(bool full);
    static void tell(gl::Program& program, const FrameView& view, int part);
    void makeRoom(size_t puffs, size_t squares);
    void compute(const FractureMesh& mesh, const FrameView& view, Tiles& tiles);
    void drawPuffs(const gl::Program& program, const FractureMesh& mesh);

    std::filesystem::path shaders_;
    gl::Texture nothing_;
    std::map<std::pair<bool, PictureKind>, gl::Program> puffs_;  ///< by fullness; made when first needed
    std::map<PictureKind, Tiles> tiles_;                         ///< likewise
    gl::Buffer seen_, boxes_, lists_;                            ///< of the puffs of a frame, computed
    bool computes_ = false;
    std::optional<Sums> sums_;
    PictureKind kind_;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
