// SPDX-License-Identifier: Apache-2.0
// A static solid on which bodies fall, as it is drawn: rendered walls of one colour, with light and shadow.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace demolish::engine {

/// As shaders/common/colliders.glsl. A plane is the face of its box towards +z alone, seen from that side
/// only: from behind it is not there, neither for the eye nor for the sun. The box's depth parts its shadow
/// from its lit side. A sphere fills its box; of a capsule the box's ends along z are round.
enum class ColliderShape : uint32_t { kBox, kPlane, kSphere, kCapsule };
inline constexpr size_t kMostColliders = 8;

/// Three corners a triangle, counter-clockwise seen from outside; of each its place in its own frame (m) and
/// its unit normal.
using ColliderTriangles = std::vector<float>;

struct ColliderDraw {
    ColliderShape shape = ColliderShape::kBox;
    glm::vec3 position{0};           ///< m, of the centre
    glm::quat rotation{1, 0, 0, 0};  ///< from its own frame to the world
    glm::vec3 half_size{0.5f};       ///< m, along the axes of its own frame
    /// What is drawn in place of a shape, made half_size times as large along each axis; null: the shape.
    std::shared_ptr<const ColliderTriangles> triangles;
    bool is_steel = false;              ///< of triangles: of iron, as projectiles are
    std::optional<glm::vec3> colour{};  ///< linear; none: the floor's
    bool operator==(const ColliderDraw&) const = default;
};

}  // namespace demolish::engine
