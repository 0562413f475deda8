// Substeps and the ball's flight, checked by the mechanics they promise.
#include "app/session/shot_setup.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demolish {
namespace {

/// A cube of 1 m on the floor, filled with n x n x n particles on a grid.
BreakableBody gridCube(int n) {
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

TEST(ShotSetup, SubstepsGoAsOneOverTheParticleSize) {
    Shot shot;
    shot.wave_speed = 91;
    BreakableBody body;
    body.bounds_max.y = 0.33;
    body.spacing = 0.0149;
    EXPECT_NEAR(substepsFor(shot, body, 0.5), 300, 3);  // models.md E.3, draft
    body.spacing = 0.0079;
    EXPECT_NEAR(substepsFor(shot, body, 0.5), 565, 6);  // and full
    shot.substeps = 123;
    EXPECT_EQ(substepsFor(shot, body, 0.5), 123u);
}

TEST(ShotSetup, TheBallTouchesTheSurfaceInTimeWithTheChosenVelocity) {
    const BreakableBody body = gridCube(12);
    for (const double velocity : {2.0, 10.0, 30.0}) {
        Shot shot;
        shot.impact.velocity = velocity;
        shot.impact.direction = {-1, 0, 0};
        const auto ball = makeBall(shot, body);
        ASSERT_TRUE(ball.has_value());
        EXPECT_DOUBLE_EQ(ball->radius, 1.0 / 12);
        const double t = shot.impact.arrival_time;
        const double x = ball->position.x + ball->velocity.x * t;
        const double y = ball->position.y + ball->velocity.y * t - 0.5 * 9.81 * t * t;
        const double vy = ball->velocity.y - 9.81 * t;
        EXPECT_NEAR(x, 0.5 + ball->radius, 0.02)
            << "one particle's depth is all that is known of the surface";
        EXPECT_NEAR(y, 0.5, 1e-9);
        EXPECT_NEAR(vy, 0, 1e-9);
        EXPECT_NEAR(ball->velocity.x, -velocity, 1e-9);
        EXPECT_GT(ball->position.y, ball->radius) << "starts above the floor";
    }
}

TEST(ShotSetup, NothingHitsAtVelocityZero) {
    const BreakableBody body = gridCube(4);
    Shot shot;
    shot.impact.velocity = 0;
    EXPECT_FALSE(makeBall(shot, body).has_value());
    shot.impact.velocity = 5;
    shot.impact.kind = ImpactKind::kDrop;
    EXPECT_FALSE(makeBall(shot, body).has_value());
}

TEST(ShotSetup, ADroppedBodyReachesTheFloorWithTheChosenVelocity) {
    Shot shot;
    shot.impact.kind = ImpactKind::kDrop;
    for (const double velocity : {0.5, 3.0, 12.0}) {
        shot.impact.velocity = velocity;
        const auto body = std::make_shared<BreakableBody>(gridCube(8));
        const SceneSetup setup = makeSetup(shot, body);
        const BodyInstance& instance = setup.bodies.at(0);
        double lowest = 1e9;
        for (const auto& particle : body->particles) lowest = std::min(lowest, particle.seed.y);
        const double gap = instance.position.y + lowest - body->spacing;
        EXPECT_GE(gap, 0);
        EXPECT_NEAR(std::sqrt(instance.velocity.y * instance.velocity.y + 2 * 9.81 * gap), velocity, 1e-9);
        EXPECT_LE(instance.velocity.y, 0);
    }
}

TEST(ShotSetup, AShotAtAPointPassesIt) {
    const BreakableBody body = gridCube(8);
    Shot shot;
    shot.impact.velocity = 20;
    const Double3 target{0.5, 0.8, 0.1};
    const Projectile ball = makeBallAt(shot, body, {3, 1.2, 2}, target);
    double nearest = 1e9;
    for (double t = 0; t < 0.1; t += 1e-4) {
        const double x = ball.position.x + ball.velocity.x * t - target.x;
        const double y = ball.position.y + ball.velocity.y * t - 0.5 * 9.81 * t * t - target.y;
        const double z = ball.position.z + ball.velocity.z * t - target.z;
        nearest = std::min(nearest, std::hypot(x, y, z));
    }
    EXPECT_LT(nearest, 0.01);
}

TEST(ShotSetup, WithoutASceneTheStiffnessFollowsStrengthAndWeight) {
    Shot shot;
    shot.material.critical_velocity = 2.5;
    shot.material.beta = 0.4;
    EXPECT_NEAR(wantedWaveSpeed(shot, 0.1), 91, 1);  // strain 0.011 at failure
    EXPECT_GT(wantedWaveSpeed(shot, 2.0), 200);      // a tall body must carry itself
}

}  // namespace
}  // namespace demolish
