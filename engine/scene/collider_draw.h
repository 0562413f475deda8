// SPDX-License-Identifier: Apache-2.0
// A static solid on which bodies fall, as it is drawn: of the floor's material, with light and shadow.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace demolish::engine {

/// As shaders/common/colliders.glsl. A plane is the face of its box towards +z alone, seen from that side
/// only: from behind it is not there, neither for the eye nor for the sun. The box's depth parts its shadow
/// from its lit side.
enum class ColliderShape : uint32_t { kBox, kPlane };
inline constexpr size_t kMostColliders = 8;

struct ColliderDraw {
    ColliderShape shape = ColliderShape::kBox;
    glm::vec3 position{0};           ///< m, of the centre
    glm::quat rotation{1, 0, 0, 0};  ///< from its own frame to the world
    glm::vec3 half_size{0.5f};       ///< m, along the axes of its own frame
    bool operator==(const ColliderDraw&) const = default;
};

}  // namespace demolish::engine
