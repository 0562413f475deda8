// SPDX-License-Identifier: Apache-2.0
// The box round each shape is drawn; what of it is the collider is found a pixel, by the ray that lights it
// too.
#include "engine/passes/collider_pass.h"

#include <algorithm>
#include <cmath>

#include "engine/scene/frame_view.h"

namespace demolish::engine {
namespace {

constexpr GLuint kBlock = 1;
constexpr GLint kRegion = 0, kId = 0, kPlace = 1, kTurn = 2, kStretch = 3, kColour = 4;
constexpr GLsizei kBoxStrip = 14;
constexpr size_t kCornerFloats = 6;
/// Of a plane's normal, upwards.
constexpr float kUpright = 0.05f;

/// std140, as shaders/common/colliders.glsl.
struct Block {
    struct Collider {
        glm::vec4 axis[3], centre, colour;
    } colliders[kMostColliders];
    uint32_t count, unused[3];
};

/// rgb; a: 1, or 0 where it is the floor's.
glm::vec4 colourOf(const ColliderDraw& draw) {
    return draw.colour ? glm::vec4(*draw.colour, 1) : glm::vec4(0);
}

/// A wall's shadow falls behind it, where it hides it itself: planes are seen from their free side only. One
/// that leans shades the floor before its edge.
bool castsShadow(const ColliderDraw& draw) {
    return draw.shape != ColliderShape::kPlane || std::abs(glm::mat3_cast(draw.rotation)[2].y) > kUpright;
}

Block::Collider packed(const ColliderDraw& from) {
    Block::Collider to;
    const glm::mat3 axes = glm::mat3_cast(from.rotation);
    for (int k = 0; k < 3; ++k) to.axis[k] = glm::vec4(axes[k], from.half_size[k]);
    to.centre = glm::vec4(from.position, static_cast<float>(from.shape));
    to.colour = colourOf(from);
    return to;
}

}  // namespace

ColliderPass::ColliderPass(const std::filesystem::path& shaders)
    : shadows_(shaders, {"collider.vert", "collider_shadow.frag"}, "#define SHADOW\n"),
      ids_(shaders, {"collider.vert", "collider_id.frag"}),
      triangle_shadows_(shaders, {"collider_triangles.vert", "shadow.frag"}, "#define SHADOW\n"),
      triangle_ids_(shaders, {"collider_triangles.vert", "id.frag"}, "#define CONSTANT_ID\n"),
      triangle_materials_(shaders, {"collider_triangles.vert", "collider_triangles.frag"}),
      block_(gl::Buffer::immutable(sizeof(Block), nullptr, GL_DYNAMIC_STORAGE_BIT)) {
    ids_.set(kId, kColliderId);
    triangle_ids_.set(kId, kColliderId);
}

std::shared_ptr<const ColliderPass::Triangles> ColliderPass::uploaded(
    const std::shared_ptr<const ColliderTriangles>& triangles) const {
    for (const Placed& placed : triangles_)
        if (placed.triangles->from == triangles) return placed.triangles;
    auto made = std::make_shared<Triangles>();
    made->from = triangles;
    made->corners = gl::Buffer::immutable(triangles->size() * sizeof(float), triangles->data());
    made->layout.floatAttribute(0, 3, GL_FLOAT, false, 0);
    made->layout.floatAttribute(1, 3, GL_FLOAT, false, 3 * sizeof(float));
    made->layout.setVertices(made->corners, kCornerFloats * sizeof(float));
    return made;
}

void ColliderPass::setColliders(std::span<const ColliderDraw> colliders) {
    Block block{};
    std::vector<Placed> of_triangles;
    count_ = 0;
    for (const ColliderDraw& from : colliders) {
        if (from.triangles != nullptr) {
            const glm::quat& q = from.rotation;
            of_triangles.push_back({uploaded(from.triangles), glm::vec4(from.position, from.is_steel ? 1 : 0),
                                    glm::vec4(q.x, q.y, q.z, q.w), glm::vec4(from.half_size, 0),
                                    colourOf(from)});
        }
    }
    const auto place = [&](bool casts) {
        for (const ColliderDraw& from : colliders)
            if (from.triangles == nullptr && castsShadow(from) == casts && count_ < kMostColliders)
                block.colliders[count_++] = packed(from);
    };
    place(true);
    casters_ = count_;
    place(false);
    triangles_ = std::move(of_triangles);
    block.count = static_cast<uint32_t>(count_);
    block_.upload(std::as_bytes(std::span(&block, 1)));
    glBindBufferBase(GL_UNIFORM_BUFFER, kBlock, block_.id());
}

void ColliderPass::drawTriangles(gl::Program& program) {
    program.use();
    for (const Placed& placed : triangles_) {
        if (&program == &triangle_materials_) program.set(kColour, placed.colour);
        program.set(kPlace, placed.place);
        program.set(kTurn, placed.turn);
        program.set(kStretch, placed.stretch);
        placed.triangles->layout.bind();
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(placed.triangles->from->size() / kCornerFloats));
    }
}

void ColliderPass::drawMaterials() {
    drawTriangles(triangle_materials_);
}

void ColliderPass::draw(const gl::Program& program, size_t count) {
    if (count == 0) return;
    program.use();
    no_attributes_.bind();
    glDisable(GL_CULL_FACE);  // the eye may be inside the box
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kBoxStrip, static_cast<GLsizei>(count));
    glEnable(GL_CULL_FACE);
}

void ColliderPass::drawShadows(int region) {
    shadows_.set(kRegion, region);
    draw(shadows_, casters_);
    triangle_shadows_.set(kRegion, region);
    drawTriangles(triangle_shadows_);
}

void ColliderPass::drawIds() {
    draw(ids_, count_);
    drawTriangles(triangle_ids_);
}

}  // namespace demolish::engine
