// SPDX-License-Identifier: Apache-2.0
// Who is under each pixel: fragment slots drawn as numbers, without anti-aliasing.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/passes/body_geometry.h"
#include "engine/passes/collider_pass.h"
#include "engine/passes/floor_pass.h"
#include "engine/passes/sphere_pass.h"
#include "engine/render/fracture_mesh.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

/// What takes part in the id picture; `mesh` and `floor` may be null. Spheres and colliders have been set on
/// their passes.
struct IdScene {
    const FractureMesh* mesh;
    BodyGeometry& body;
    SpherePass& spheres;
    ColliderPass& colliders;
    FloorPass* floor;
};

class IdPass {
  public:
    explicit IdPass(const std::filesystem::path& shaders);
    /// x, y from the top left, inside the picture; only that pixel is drawn.
    Pick pick(const IdScene& scene, const FrameView& view, int x, int y);
    /// Rows from the top down.
    std::vector<uint32_t> readAll(const IdScene& scene, const FrameView& view);

  private:
    void draw(const IdScene& scene, const FrameView& view);
    gl::Program body_;
    gl::Texture ids_, depth_;
    gl::Framebuffer framebuffer_;
};

}  // namespace demolish::engine
