// SPDX-License-Identifier: Apache-2.0
// Pieces of broken bodies as points for convex hulls.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish::bullet {

struct Piece {
    std::vector<glm::dvec3> corners;  ///< m, from the centre of mass
    glm::dvec3 centre{0};             ///< m, in the scene
    double mass = 0;                  ///< kg
    double friction = 0, restitution = 0;
    uint32_t fragment = 0;  ///< its name in the frames of our solver
    uint32_t body = 0;      ///< of the setup, that it is part of
};

/// One for each fragment. fragment: of every cell of the bodies, which stand as the setup places them.
std::vector<Piece> piecesOf(const SceneSetup& setup, std::span<const uint32_t> fragment);

}  // namespace demolish::bullet
