// SPDX-License-Identifier: Apache-2.0
// Where a projectile starts that would start inside something: a ball pressed into a body from its first
// moment would bring in energy that nobody has thrown it with.
#pragma once
#include <vector>

#include "sim_cuda/api/params.h"
#include "sim_cuda/physics/vector.h"

namespace demolish {

struct Ball {
    Vec3<double> centre;  ///< m
    double radius = 0;    ///< m
};

/// The projectile farther back on its straight way, where it overlaps none of the others, and out of the
/// colliders along their normals; one that rests, or whose way back has no end, goes up. As it is where it
/// touches nothing.
Projectile placedFree(const Projectile& shot, const std::vector<Ball>& others,
                      const std::vector<Collider>& colliders);

}  // namespace demolish
