// SPDX-License-Identifier: Apache-2.0
// Dust over the finished picture: puffs added up at a part of its size, softened at what they meet, lit and
// shadowed, then laid over it.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/render_targets.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class DustPass {
  public:
    explicit DustPass(const std::filesystem::path& shaders);
    /// As LightPass::showColliders().
    void showColliders(bool shows) { with_colliders_ = shows; }
    /// What dust of this frame leaves of the sun, for all that asks the shadow map: of `mesh` (null: none, as
    /// in drafts). Binds unit 8, as shaders/common/dust_shadow.glsl has it.
    void castShadows(const FractureMesh* mesh);
    /// Over `framebuffer`, which the light pass has filled. The shadow map (unit 1), castShadows() and the
    /// noise volume are bound. `nearest_depth`: AmbientOcclusionPass::nearestDepth() of this frame; null, of
    /// drafts: the depth of `targets` counts.
    void draw(const FractureMesh& mesh, const FrameView& view, const RenderTargets& targets,
              const gl::Texture* nearest_depth, GLuint framebuffer);

  private:
    struct Sums {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };
    void fit(int width, int height);
    gl::Program& puffsFor(const RenderTargets& targets, bool full);
    void addPuffs(const FractureMesh& mesh, const FrameView& view, gl::Program& program, int part);
    void run(const gl::Program& program, const FractureMesh& mesh);

    std::filesystem::path shaders_;
    gl::Program shadows_, over_;
    gl::Texture no_shadow_;
    /// By samples, fullness and whether there are colliders; made when first needed.
    std::map<std::tuple<int, bool, bool>, gl::Program> puffs_;
    std::optional<Sums> sums_, shadow_sums_;
    bool with_colliders_ = false;
    gl::VertexArray no_attributes_;
};

}  // namespace demolish::engine
