// SPDX-License-Identifier: Apache-2.0
// Bodies made by hand for the solver's tests: bricks of cubic cells, exact in volume, area and distance.
#pragma once
#include <memory>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

/// nx x ny x nz cubes of edge h (m), the lowest at y = 0, centred in x and z. `jitter` moves each seed by up
/// to that share of h in each direction (faces keep their areas), so that forces have no symmetry. Without
/// draw geometry.
std::shared_ptr<const BreakableBody> latticeBody(uint32_t nx, uint32_t ny, uint32_t nz, double h,
                                                 double jitter = 0, uint64_t seed = 1);

/// A single particle: a ball of radius R (m) that touches y = 0 from above and has its true inertia.
std::shared_ptr<const BreakableBody> ballBody(double R);

/// One body at rest on no plane, without gravity: a free body. Callers change what they need.
SceneSetup freeBody(std::shared_ptr<const BreakableBody> body);

/// A free body of 30 particles, undamped and unbreakable, that spins about x (rad/s).
SceneSetup spinningBody(double spin);

/// Weak ceramic that a fall of a few m/s breaks.
Material brittleMaterial();

}  // namespace demolish::tests
