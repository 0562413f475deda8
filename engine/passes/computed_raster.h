// SPDX-License-Identifier: Apache-2.0
// Finds in compute passes what every sample of the picture and every texel of the shadow map shows.
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <optional>

#include "engine/gl/pass_clock.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/passes/collider_pass.h"
#include "engine/passes/shadow_pass.h"
#include "engine/passes/sphere_pass.h"
#include "engine/passes/triangle_raster.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class ComputedRaster {
  public:
    /// `task_room`: as TriangleRaster's. Throws gl::GlError.
    ComputedRaster(const std::filesystem::path& shaders, size_t task_room);

    /// Has the driver as many and as large storage bindings as this picture of this mesh takes?
    static bool suits(const FractureMesh& mesh, int width, int height, int samples);

    /// Makes the shaders for these targets, which run() would do otherwise. Throws GlError.
    void prepare(const RenderTargets& targets, bool with_colliders);

    /// For the frame whose uniforms are bound. The shadow map is made anew when it does not hold `scene`, in
    /// regions of `shadow_texels` squared. All that later passes read stays bound, but for bindShadowMap().
    void run(const FractureMesh& mesh, const NearFaces* near, const SpherePass& balls,
             const ColliderPass& colliders, const RenderTargets& targets, const ShadowScene& scene,
             int shadow_texels, gl::PassClock& clock);
    /// Adds hairlines, of `width` m, to what run() found; the noise volume is bound.
    void addCracks(const FractureMesh& mesh, const RenderTargets& targets, const SurfaceLook& look);
    /// The light pass has emptied what run() and addCracks() have put into the picture's samples, so that the
    /// next frame need not: clearing all of them took a twentieth of a frame's drawing.
    void leftEmpty() { visible_is_empty_ = true; }
    /// To units 1 and 7, as shaders/common/shadow.glsl has it.
    void bindShadowMap() const;

  private:
    void makeRoom(const FractureMesh& mesh, const RenderTargets& targets, int shadow_texels);
    void bind(const FractureMesh& mesh, const NearFaces* near, const SpherePass& balls) const;
    struct Programs {
        TriangleRaster::Programs triangles;
        gl::Program balls, grit, cracks;
        /// Those that know the views.
        std::array<gl::Program*, 6> raster() {
            return {&triangles.triangles, &triangles.setup, &triangles.squares,
                    &triangles.large,     &balls,           &grit};
        }
    };
    Programs& programsFor(const RenderTargets& targets);
    void clear(int shadow_texels);
    void castColliderShadows(const ColliderPass& colliders, int shadow_texels);
    void makeCoarseShadows();
    struct Drawn {
        const SpherePass& balls;
        bool grit, shadows;
    };
    static void rasterise(Programs& programs, const Drawn& drawn, bool naming);

    std::filesystem::path shaders_;
    TriangleRaster triangles_;
    gl::Program coarse_, colliders_;    ///< the second: made when first needed
    std::map<int, Programs> programs_;  ///< by samples, made when first needed
    gl::Buffer visible_;
    gl::Texture shadow_bits_, shadow_depth_;  ///< the same memory, as R32UI and R32F
    gl::Texture shadow_coarse_;               ///< least depth of squares of it
    std::optional<ShadowScene> shadow_scene_;
    bool visible_is_empty_ = false;
};

}  // namespace demolish::engine
