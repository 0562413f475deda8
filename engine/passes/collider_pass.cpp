// SPDX-License-Identifier: Apache-2.0
// The box round each is drawn; what of it is the collider is found a pixel, by the ray that lights it too.
#include "engine/passes/collider_pass.h"

#include <algorithm>

#include "engine/scene/frame_view.h"

namespace demolish::engine {
namespace {

constexpr GLuint kBlock = 1;
constexpr GLint kRegion = 0, kId = 0;
constexpr GLsizei kBoxStrip = 14;

/// std140, as shaders/common/colliders.glsl.
struct Block {
    struct Collider {
        glm::vec4 axis[3], centre;
    } colliders[kMostColliders];
    uint32_t count, unused[3];
};

}  // namespace

ColliderPass::ColliderPass(const std::filesystem::path& shaders)
    : shadows_(shaders, {"collider.vert", "collider_shadow.frag"}, "#define SHADOW\n"),
      ids_(shaders, {"collider.vert", "collider_id.frag"}),
      block_(gl::Buffer::immutable(sizeof(Block), nullptr, GL_DYNAMIC_STORAGE_BIT)) {
    ids_.set(kId, kColliderId);
}

void ColliderPass::setColliders(std::span<const ColliderDraw> colliders) {
    Block block{};
    count_ = std::min(colliders.size(), kMostColliders);
    block.count = static_cast<uint32_t>(count_);
    for (size_t c = 0; c < count_; ++c) {
        const ColliderDraw& from = colliders[c];
        const glm::mat3 axes = glm::mat3_cast(from.rotation);
        for (int k = 0; k < 3; ++k) block.colliders[c].axis[k] = glm::vec4(axes[k], from.half_size[k]);
        block.colliders[c].centre = glm::vec4(from.position, static_cast<float>(from.shape));
    }
    block_.upload(std::as_bytes(std::span(&block, 1)));
    glBindBufferBase(GL_UNIFORM_BUFFER, kBlock, block_.id());
}

void ColliderPass::draw(const gl::Program& program) {
    if (count_ == 0) return;
    program.use();
    no_attributes_.bind();
    glDisable(GL_CULL_FACE);  // the eye may be inside the box
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kBoxStrip, static_cast<GLsizei>(count_));
    glEnable(GL_CULL_FACE);
}

void ColliderPass::drawShadows(int region) {
    shadows_.set(kRegion, region);
    draw(shadows_);
}

void ColliderPass::drawIds() {
    draw(ids_);
}

}  // namespace demolish::engine
