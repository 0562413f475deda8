// SPDX-License-Identifier: Apache-2.0
// Convex pieces, balls and a floor in Bullet's rigid-body world, as its manual sets one up.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <span>
#include <vector>

#include "tests/bullet/piece_hulls.h"

namespace demolish::bullet {

/// Pieces stand asleep until something touches them.
class World {
  public:
    explicit World(std::span<const Piece> pieces);
    ~World();

    /// From now on.
    void fire(const Projectile& ball);
    /// s; Bullet's steps are of 1/240 s, a quarter of its usual 1/60: a ball of 13 m/s passes through pieces
    /// else.
    void advance(double seconds);

    double energy() const;                  ///< J, kinetic and potential, balls included
    glm::dvec3 centre(size_t piece) const;  ///< m
    glm::dquat turn(size_t piece) const;    ///< since the start
    size_t pieces() const;
    struct Ball {
        glm::dvec3 centre{0};  ///< m
        double radius = 0;     ///< m
    };
    std::vector<Ball> balls() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace demolish::bullet
