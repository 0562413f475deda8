// SPDX-License-Identifier: Apache-2.0
// Placement of bodies and balls, and the search for the speed that breaks.
#include "tests/physics/models/shots.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/physics/quaternion.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

Quat<double> turnAbout(const Vec3<double>& axis, double angle) {
    const double s = std::sin(angle / 2);
    return {s * axis.x, s * axis.y, s * axis.z, std::cos(angle / 2)};
}

/// m, height of the turned body's lowest corner.
double lowestCorner(const BreakableBody& body, const Quat<double>& q) {
    double lowest = 1e300;
    for (size_t i = 0; i < body.particles.size(); ++i) {
        const Double3 seed = body.particles[i].seed;
        for (uint32_t c = body.corners.start[i]; c < body.corners.start[i + 1]; ++c) {
            const Double3 corner = body.corners.from_seed[c];
            lowest = std::min(
                lowest, rotate(q, Vec3<double>{seed.x + corner.x, seed.y + corner.y, seed.z + corner.z}).y);
        }
    }
    return lowest;
}

}  // namespace

Material sheetMaterial(double critical_velocity, uint32_t cells) {
    Material material;
    material.critical_velocity = critical_velocity;
    material.tough_cells = cells;
    material.restitution = 0.2;
    material.rolling_friction = 0.2;
    return material;
}

SceneSetup standing(std::shared_ptr<const BreakableBody> body, const Material& material, uint32_t substeps) {
    SceneSetup setup;
    setup.bodies.push_back({std::move(body), material, {}, {}, {}, {}});
    setup.params.substeps = substeps;
    setup.params.gravity = {0, 0, 0};
    return setup;
}

SceneSetup dropped(std::shared_ptr<const BreakableBody> body, const Material& material, uint32_t substeps,
                   const Double3& tilt, double speed) {
    const Quat<double> q = multiply(turnAbout({0, 0, 1}, tilt.z),
                                    multiply(turnAbout({0, 1, 0}, tilt.y), turnAbout({1, 0, 0}, tilt.x)));
    const double lowest = lowestCorner(*body, q);
    SceneSetup setup = standing(std::move(body), material, substeps);
    setup.bodies[0].rotation = {q.x, q.y, q.z, q.w};
    setup.bodies[0].position = {0, -lowest, 0};
    setup.bodies[0].velocity = {0, -speed, 0};
    return setup;
}

SceneSetup hitByBall(std::shared_ptr<const BreakableBody> body, const Material& material, uint32_t substeps,
                     double ball_radius, double speed, double height_fraction) {
    const double height = body->bounds_max.y - body->bounds_min.y;
    double middle = 0, touched = -1e300;
    size_t near = 0;
    const double y = height_fraction * height;
    for (const Particle& p : body->particles) {
        if (std::abs(p.seed.y - y) > 0.1 * height) continue;
        middle += p.seed.z;
        ++near;
    }
    middle /= static_cast<double>(std::max<size_t>(near, 1));
    for (const Particle& p : body->particles)
        if (std::hypot(p.seed.y - y, p.seed.z - middle) < ball_radius + p.depth)
            touched = std::max(touched, p.seed.x + p.depth);
    SceneSetup setup = standing(std::move(body), material, substeps);
    Projectile ball;
    ball.radius = ball_radius;
    ball.position = {touched + ball_radius, y, middle};
    ball.velocity = {-speed, 0, 0};
    setup.projectiles.push_back(ball);
    return setup;
}

double thresholdSpeed(const std::function<SceneSetup(double speed)>& shot, double low, double high,
                      int rounds) {
    for (int round = 0; round < rounds; ++round) {
        const double speed = std::sqrt(low * high);
        const SceneSetup setup = shot(speed);
        auto solver = makeSolver(setup);
        for (int frame = 0; frame < 6; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        (PieceCounter(setup).count(*solver).broken() ? high : low) = speed;
    }
    return std::sqrt(low * high);
}

}  // namespace demolish::tests
