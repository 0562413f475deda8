// SPDX-License-Identifier: Apache-2.0
// A body without authoring: particles on a grid in a cube.
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/breakable_body.h"

namespace demolish::test {

/// A cube of 1 m on the floor, filled with n x n x n particles on a grid.
inline BreakableBody gridCube(int n) {
    BreakableBody body;
    body.spacing = 1.0 / n;
    body.mesh_volume = 1;
    body.bounds_min = {-0.5, 0, -0.5};
    body.bounds_max = {0.5, 1, 0.5};
    for (int k = 0; k < n * n * n; ++k) {
        const auto at = [n](int index) { return (index + 0.5) / n; };
        Particle particle;
        particle.seed = {at(k % n) - 0.5, at(k / n % n), at(k / n / n) - 0.5};
        const auto inside = [](double x) { return 0.5 - std::abs(x); };
        particle.depth =
            std::min({inside(particle.seed.x), inside(particle.seed.y - 0.5), inside(particle.seed.z)});
        body.particles.push_back(particle);
    }
    return body;
}

}  // namespace demolish::test
