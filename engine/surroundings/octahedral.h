// SPDX-License-Identifier: Apache-2.0
// Directions on a square, as shaders/common/gbuffer.glsl encodes them: a map of all directions without seams,
// once it has a border of a texel that repeats what lies beyond its folded edge.
#pragma once
#include <glm/glm.hpp>

namespace demolish::engine {

/// -1..1 each; any length but 0.
glm::vec2 toOctahedral(glm::vec3 direction);
/// Unit, through the middle of a texel of a map of side x side texels, its border included.
glm::vec3 octahedralTexel(int x, int y, int side);
/// The same map's place of a direction, in texels from the middle of the first.
glm::vec2 octahedralPlace(glm::vec3 direction, int side);

}  // namespace demolish::engine
