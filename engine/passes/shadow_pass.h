// SPDX-License-Identifier: Apache-2.0
// The sun's depth map, and its binding for the passes that ask whether a point is lit.
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/passes/body_geometry.h"
#include "engine/passes/depth_eraser.h"
#include "engine/render/small_triangles.h"
#include "engine/scene/collider_draw.h"

namespace demolish::engine {

inline constexpr int kShadowRegions = 2;
/// By how much the map's depths lie behind what casts shadow: in slopes, and in steps of its format.
inline constexpr float kShadowSlopes = 1.1f, kShadowSteps = 2.0f;

/// What the map shows: frames that agree in it share the map.
struct ShadowScene {
    uint64_t mesh_version = 0;  ///< 0: no mesh
    uint64_t near_version = 0;  ///< 0: no near faces
    bool as_particles = false, with_grit = false, with_body = true, with_looks = false;
    uint32_t hidden_looks = 0;
    std::vector<float> spheres;  ///< position and radius of each
    std::vector<ColliderDraw> colliders;
    glm::mat4 light_matrix[2] = {glm::mat4(0), glm::mat4(0)};
    bool operator==(const ShadowScene&) const = default;
};

class ShadowPass {
  public:
    explicit ShadowPass(const std::filesystem::path& shaders);
    /// Does the map hold this scene, in regions of `size` texels? If not it is remembered: the caller draws
    /// it.
    bool holds(const ShadowScene& scene, int size);
    /// Binds and clears the map of two regions of `size` x `size` texels. Then, for each region: enter(), and
    /// the passes that cast shadows draw. Then finish().
    /// `erase_tiles`: only where something was drawn last time (DepthEraser).
    void begin(int size, bool erase_tiles);
    /// `region`: 0 near, 1 far (FrameUniforms::light_matrix).
    /// `small`: what the CPU has found of it, null: nothing.
    void enter(int region, const SmallTriangles* small);
    /// `with_looks`: without what the models' own looks cut out. `near` and `seen` as in BodyGeometry.
    void drawBody(BodyGeometry& body, const FractureMesh& mesh, uint32_t hidden_looks, bool with_looks,
                  const NearFaces* near, const SeenList* seen);
    void finish(bool erase_tiles);
    /// Units 0 (compared) and 1 (plain), as shaders/common/shadow.glsl has them.
    void bindMap() const;
    static void unbindMap();

  private:
    void putSmall(const SmallTriangles& small);
    std::filesystem::path shaders_;
    gl::Program body_, masked_;  ///< the second: made when first needed
    int region_ = 0;
    gl::Texture map_;
    gl::Framebuffer framebuffer_;
    gl::Sampler compare_, plain_;
    DepthEraser eraser_;
    ShadowScene scene_;
};

}  // namespace demolish::engine
