// SPDX-License-Identifier: Apache-2.0
// The lower half of the octahedron is folded outwards.
#include "engine/surroundings/octahedral.h"

#include <algorithm>
#include <cmath>

namespace demolish::engine {

glm::vec2 toOctahedral(glm::vec3 n) {
    n /= std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (n.z >= 0) return {n.x, n.y};
    return {(1 - std::abs(n.y)) * (n.x >= 0 ? 1.0f : -1.0f), (1 - std::abs(n.x)) * (n.y >= 0 ? 1.0f : -1.0f)};
}

glm::vec3 octahedralTexel(int x, int y, int side) {
    const float inner = static_cast<float>(side - 2);
    glm::vec2 e = 2.0f * (glm::vec2(x, y) - 0.5f) / inner - 1.0f;
    // Texels of the border are those of the map beyond its edge, where it goes on folded.
    for (int axis = 0; axis < 2; ++axis)
        if (std::abs(e[axis]) > 1) {
            e[axis] = std::copysign(2 - std::abs(e[axis]), e[axis]);
            e[1 - axis] = -e[1 - axis];
        }
    glm::vec3 n(e, 1 - std::abs(e.x) - std::abs(e.y));
    const float fold = std::max(-n.z, 0.0f);
    n.x += n.x >= 0 ? -fold : fold;
    n.y += n.y >= 0 ? -fold : fold;
    return glm::normalize(n);
}

glm::vec2 octahedralPlace(glm::vec3 direction, int side) {
    return 0.5f + (0.5f + 0.5f * toOctahedral(direction)) * static_cast<float>(side - 2);
}

}  // namespace demolish::engine
