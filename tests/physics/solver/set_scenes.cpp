// SPDX-License-Identifier: Apache-2.0
#include "tests/physics/solver/set_scenes.h"

#include <cmath>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/turned_body.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {

SceneSetup heldScene() {
    constexpr double kEdge = 0.05;
    SceneSetup setup = freeBody(latticeBody(3, 10, 3, kEdge, 0.2));
    setup.bodies[0].material.critical_velocity = 1.5;
    setup.bodies[0].position = {0, -kEdge, 0};
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].body = latticeBody(2, 2, 2, kEdge);
    setup.bodies[1].material.critical_velocity = 1e6;
    setup.bodies[1].position = {-0.35, 0.3, 0.02};
    Anchor ground;
    ground.region = Box{{1, 0.1, 1}, {0, -0.05, 0}, {}};
    ground.body = 0;
    Anchor hand;
    hand.body = 1;
    hand.pivot = {-0.35, 0.8, 0.02};
    hand.path = {{{0.02, {}, {}}, {0.12, {0.6, 0, 0}, {0, 0, 1.2}}}, true};
    setup.anchors = {ground, hand};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 300;
    return setup;
}

SceneSetup mortarScene() {
    constexpr double kLength = 0.24, kHeight = 0.071, kDepth = 0.115, kGap = 0.0005;  // m, of a brick
    const auto mesh = loadSolidMesh(DEMOLISH_SOURCE_DIR "/assets/models/brick.obj", {.height = kHeight});
    const auto stretcher = fillWithParticles(*mesh, {.particles = 20});
    const auto header =
        turnedBody(*fillWithParticles(*mesh, {.particles = 34}), {0, std::sqrt(0.5), 0, std::sqrt(0.5)});
    SceneSetup setup;
    for (uint32_t row = 0; row < 6; ++row) {
        const bool headers = row % 2 == 1;
        for (uint32_t k = 0; k < (headers ? 6 : 3); ++k) {
            BodyInstance brick;
            brick.body = headers ? header : stretcher;
            brick.material = brittleMaterial();
            brick.material.tough_cells = 0;
            if (headers) {
                brick.material.density *= 1.3;
                brick.material.critical_velocity *= 0.6;
                brick.material.friction = 0.35;
            }
            brick.position = {headers ? (kDepth + kGap) * k - 0.06 : (kLength + kGap) * k,
                              row * (kHeight + kGap), 0};
            setup.bodies.push_back(brick);
        }
    }
    Projectile ball;
    ball.radius = 0.06;
    ball.position = {0.25, 0.25, 0.3};
    ball.velocity = {0, 0, -9};
    setup.projectiles.push_back(ball);
    setup.params.colliders.push_back(Plane{});
    setup.params.settle_time = 0.05;
    setup.params.substeps = 300;
    setup.mortar = Mortar{0.25 * setup.bodies[0].material.tensile_strength, 0.001};
    return setup;
}

SceneSetup dryScene() {
    SceneSetup setup = mortarScene();
    setup.mortar.reset();
    return setup;
}

}  // namespace demolish::tests
