// SPDX-License-Identifier: Apache-2.0
// What the ends of a particle's colour scale stand for.
#pragma once
#include "sim_cuda/api/solver.h"

namespace demolish {

/// m/s, at which ParticleColour::kSpeed reaches the end of its scale: twice the first body's v_c.
inline double speedOfFullColour(const SceneSetup& setup) {
    return 2 * setup.bodies[0].material.critical_velocity;
}

}  // namespace demolish
