// SPDX-License-Identifier: Apache-2.0
// From the materials of the bodies: when their bonds come to rest, and which hits wake them.
#pragma once
#include <algorithm>
#include <vector>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/physics/hand_over.h"
#include "sim_cuda/solver/body_constants.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

template <class Real>
struct WakeLaws {
    std::vector<double> calm_speed2;  ///< m^2/s^2, per owner
    std::vector<WakeLaw<Real>> wake;  ///< per owner
    double gentlest_hit = 1e30;       ///< m/s: no slower meeting wakes bonds
};

/// Of a painted body by its weakest paint. Projectiles have no bonds.
template <class Real>
WakeLaws<Real> wakeLaws(const SceneSetup& setup, const SceneTables& tables) {
    WakeLaws<Real> laws;
    laws.calm_speed2.resize(tables.owners(), 0.0);
    laws.wake.resize(tables.owners(), {Real(1e30), Real(1e30), Real(1e30)});
    for (uint32_t b = 0; b < tables.bodies; ++b) {
        const BodyInstance& body = setup.bodies[b];
        const Material& material = body.material;
        const double critical = weakestPainted(*body.body) * material.critical_velocity;
        const double speed = calmSpeed(material.beta, critical);
        laws.calm_speed2[b] = speed * speed;
        const WakeLaw<double> law = wakeLaw(material.beta, critical, body.threshold_share,
                                            static_cast<double>(body.body->particles.size()));
        laws.wake[b] = {static_cast<Real>(law.heavy), static_cast<Real>(law.light),
                        static_cast<Real>(law.body)};
        laws.gentlest_hit = std::min(laws.gentlest_hit, law.heavy);
    }
    return laws;
}

}  // namespace demolish
