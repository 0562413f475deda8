// SPDX-License-Identifier: Apache-2.0
// Colliders in the shadow map and in the id picture; the light pass finds their shapes without their being
// drawn. Those of triangles are drawn like bodies.
#pragma once
#include <filesystem>
#include <span>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/scene/collider_draw.h"

namespace demolish::engine {

class ColliderPass {
  public:
    explicit ColliderPass(const std::filesystem::path& shaders);
    /// Those of the coming frame, the first kMostColliders of them; binds them for all passes.
    void setColliders(std::span<const ColliderDraw> colliders);
    /// Of shapes, without those of triangles.
    size_t count() const { return count_; }
    /// So many of them, the first, cast shadows: all but upright planes.
    size_t casters() const { return casters_; }
    bool hasTriangles() const { return !triangles_.empty(); }
    /// Those of triangles, into the bound material targets.
    void drawMaterials();
    /// `region` of the shadow map, as ShadowPass::enter().
    void drawShadows(int region);
    void drawIds();

  private:
    /// On the GPU as long as frames show it.
    struct Triangles {
        std::shared_ptr<const ColliderTriangles> from;
        gl::Buffer corners;
        gl::VertexArray layout;
    };
    struct Placed {
        std::shared_ptr<const Triangles> triangles;
        /// m, and 1 of steel; quaternion; how much larger along each axis; ColliderDraw::colour, and 1.
        glm::vec4 place, turn, stretch, colour;
    };
    std::shared_ptr<const Triangles> uploaded(
        const std::shared_ptr<const ColliderTriangles>& triangles) const;
    void draw(const gl::Program& program, size_t count);
    void drawTriangles(gl::Program& program);
    gl::Program shadows_, ids_, triangle_shadows_, triangle_ids_, triangle_materials_;
    gl::VertexArray no_attributes_;
    gl::Buffer block_;
    size_t count_ = 0, casters_ = 0;
    std::vector<Placed> triangles_;
};

}  // namespace demolish::engine
