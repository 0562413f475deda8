// SPDX-License-Identifier: Apache-2.0
// Colliders in the shadow map and in the id picture; the light pass finds them without their being drawn.
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
    size_t count() const { return count_; }
    /// `region` of the shadow map, as ShadowPass::enter().
    void drawShadows(int region);
    void drawIds();

  private:
    void draw(const gl::Program& program);
    gl::Program shadows_, ids_;
    gl::VertexArray no_attributes_;
    gl::Buffer block_;
    size_t count_ = 0;
};

}  // namespace demolish::engine
