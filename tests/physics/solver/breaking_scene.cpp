// SPDX-License-Identifier: Apache-2.0
// The common scene of the determinism and parity tests.
#include "tests/physics/solver/breaking_scene.h"

#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {

SceneSetup breakingScene() {
    SceneSetup setup = freeBody(latticeBody(8, 10, 8, 0.03, 0.2));
    BodyInstance& body = setup.bodies[0];
    body.material.critical_velocity = 2;
    body.material.weibull_modulus = 6;
    body.material.tough_cells = 15;
    body.position = {0, 0.12, 0};
    body.rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
    body.velocity = {0.5, -4, 0};
    body.angular_velocity = {1, 2, -1};
    Projectile ball;
    ball.radius = 0.05;
    ball.position = {-0.26, 0.3, 0.02};
    ball.velocity = {12, 0, 1};
    ball.start_time = 0.004;
    setup.projectiles.push_back(ball);
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 300;
    return setup;
}

std::vector<uint64_t> hashesOf(Solver& solver) {
    std::vector<uint64_t> hashes;
    uint32_t done = 0;
    for (const uint32_t substeps : kHashedSubsteps) {
        if (solver.advanceSubsteps(substeps - done) != StepStatus::kOk) return hashes;
        done = substeps;
        hashes.push_back(solver.stateHash());
    }
    return hashes;
}

}  // namespace demolish::tests
