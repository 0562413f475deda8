// SPDX-License-Identifier: Apache-2.0
// What a scene is surrounded by, made ready for drawing: plain values, no OpenGL.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/surroundings/sun.h"

namespace demolish::engine {

/// Spherical harmonics up to order 2 with all constants inside, so that the sum of coefficient times 1, y, z,
/// x, xy, yz, 3 z^2 - 1, xz, x^2 - y^2 is the mean radiance over the hemisphere about a normal (irradiance /
/// pi).
using Harmonics = std::array<glm::vec3, 9>;
glm::vec3 evaluate(const Harmonics& harmonics, glm::vec3 normal);

/// What rough surfaces mirror (split sum): layers of roughness 0, 1/(n-1) .. 1, each an octahedral map about
/// +z with a border of a texel.
struct MirroredLayers {
    int side = 0, layers = 0;
    std::vector<glm::vec3> texels;  ///< layer by layer, rows upwards
};

struct Surroundings {
    RadiancePicture backdrop;    ///< what the eye sees, without the sun
    Harmonics above{}, below{};  ///< of the upper half of the backdrop, and of the lower one
    MirroredLayers mirrored;
    std::optional<Sun> sun;
};

/// `sun`: what the picture's sun was, which is no longer in it. Takes tenths of a second.
std::shared_ptr<const Surroundings> makeSurroundings(RadiancePicture picture, std::optional<Sun> sun);

}  // namespace demolish::engine
