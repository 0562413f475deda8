// SPDX-License-Identifier: Apache-2.0
// Real trials on a small block: the solver decides what breaks.
#include "app/calibrate/impact_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/calibrate/calibration.h"
#include "app/session/scene_file.h"
#include "app/session/shot_setup.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

Shot smallBlock(ImpactKind kind) {
    Shot shot = loadScene("block");
    shot.fineness.particles = 200;
    shot.device = DeviceChoice::kCpu;
    shot.impact.kind = kind;
    shot.impact.tilt = {0.3, 0, 0.4};
    shot.material.weibull_modulus = 0;
    return shot;
}

std::shared_ptr<const BreakableBody> bodyOf(const Shot& shot) {
    return fillPackings(shot, *loadSolidMesh(shot.model, {.height = shot.height}), 1, false, {}).at(0);
}

TEST(ImpactTrial, HoldsWhenSlowBreaksWhenFastInAnyOrder) {
    for (const ImpactKind kind : {ImpactKind::kBall, ImpactKind::kDrop}) {
        const Shot shot = trialShot(smallBlock(kind));
        ImpactTrial trial(shot, bodyOf(shot), {});
        EXPECT_FALSE(trial.breaksAt(1));
        EXPECT_TRUE(trial.breaksAt(100));
        EXPECT_FALSE(trial.breaksAt(1)) << "a trial must not leave its mark on the next one";
        EXPECT_GE(trial.simulated(), 2 * trialSeconds(kind, 1, 1));
    }
}

TEST(ImpactTrial, LastsAsLongAsTheImpactTakes) {
    EXPECT_EQ(trialSeconds(ImpactKind::kBall, 1, 50), kLeastTrial);
    EXPECT_NEAR(trialSeconds(ImpactKind::kBall, 0.5, 4), 0.25, 1e-12);
    EXPECT_NEAR(trialSeconds(ImpactKind::kBall, 0.5, 8) * 8, trialSeconds(ImpactKind::kBall, 0.5, 4) * 4,
                1e-12)
        << "the same way, so that thresholds are proportional to the strength";
    EXPECT_NEAR(trialSeconds(ImpactKind::kDrop, 0.5, 1), 0.25, 1e-12);
    EXPECT_EQ(trialSeconds(ImpactKind::kDrop, 2, 0.1), kLongestTrial);
}

/// The particles of a wall one cell thick touch as spheres wider than the wall: a slow ball placed at the
/// surface would begin inside them.
TEST(ImpactTrial, ASlowBallStartsClearOfAThinWall) {
    Shot shot = loadScene("vase");
    shot.fineness.particles = 500;
    shot = trialShot(shot);
    const auto body = bodyOf(shot);
    const ImpactTrial trial(shot, body, {});
    std::vector<double> radius(body->particles.size(), 1);
    for (const BondGeometry& bond : body->bonds)
        for (const uint32_t end : {bond.i, bond.j}) radius[end] = std::min(radius[end], bond.length / 2);
    const BodyInstance& instance = trial.setup().bodies[0];
    const Quaternion& q = instance.rotation;
    for (const double speed : {0.6, 1.0, 4.0}) {
        const Projectile ball = trial.ballAt(speed).ball;
        double gap = 1;
        for (size_t i = 0; i < radius.size(); ++i) {
            const Double3& seed = body->particles[i].seed;
            const glm::dvec3 at = glm::dquat(q.w, q.x, q.y, q.z) * glm::dvec3(seed.x, seed.y, seed.z);
            const glm::dvec3 away(ball.position.x - instance.position.x - at.x,
                                  ball.position.y - instance.position.y - at.y,
                                  ball.position.z - instance.position.z - at.z);
            gap = std::min(gap, glm::length(away) - ball.radius - radius[i]);
        }
        EXPECT_GT(gap, 0) << speed;
        EXPECT_LT(gap, 0.015 + 0.004 * speed) << speed << ": nor far off";
    }
}

/// Strength is proportional to the wave speed: a body that got another one at another size would break
/// otherwise. Walls of one cell (vase) and legs (wolf) differ most from the usual kappa.
TEST(ImpactTrial, TheWaveSpeedIsTheScenesAtEverySize) {
    for (const char* scene : {"vase", "wolf", "bunny"})
        for (const uint32_t particles : {200u, 600u}) {
            Shot shot = loadScene(scene);
            shot.fineness.particles = particles;
            SceneSetup setup = makeSetup(trialShot(shot), {bodyOf(shot)});
            setup.params.settle_time = 0;
            const double speed = makeCpuSolver(setup)->softening().wave_speed;
            EXPECT_GE(speed / shot.wave_speed, 0.999) << scene << ' ' << particles;
            EXPECT_LE(speed / shot.wave_speed, 1 + 1.1 / setup.params.substeps) << scene << ' ' << particles;
        }
}

TEST(ImpactTrial, AsksForTheBodyThatTheFastestBallHits) {
    Shot shot = smallBlock(ImpactKind::kBall);
    shot.bodies.resize(3);
    shot.bodies[2].yaw = 0.5;
    shot.bodies[2].position = {4, 0, 0};
    shot.balls.resize(2);
    shot.balls[0].speed_share = 0.3;
    shot.balls[1].body = 2;
    const Shot trial = trialShot(shot);
    ASSERT_EQ(trial.bodies.size(), 1u);
    EXPECT_EQ(trial.bodies[0].yaw, 0.5);
    EXPECT_EQ(trial.bodies[0].position.x, 0);
    ASSERT_EQ(trial.balls.size(), 1u);
    EXPECT_EQ(trial.balls[0].speed_share, 1);
    EXPECT_EQ(trial.balls[0].body, 0u);
    EXPECT_FALSE(trial.hand_over || trial.sleeping);
}

TEST(ImpactTrial, FinerStepsKeepTheStiffness) {
    const Shot shot = trialShot(smallBlock(ImpactKind::kBall));
    const auto body = bodyOf(shot);
    const ImpactTrial usual(shot, body, {}), fine(shot, body, {.finer_steps = 2});
    const auto stiffness = [](const ImpactTrial& trial) {
        return makeCpuSolver(trial.setup())->softening().bond_modulus;
    };
    EXPECT_EQ(fine.setup().params.substeps, 2 * usual.setup().params.substeps);
    EXPECT_NEAR(stiffness(fine) / stiffness(usual), 1, 1e-9);
}

class Calibrated : public testing::Test {
  protected:
    void SetUp() override { setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1); }
    void TearDown() override { unsetenv("XDG_CACHE_HOME"); }
    test::TemporaryFolder folder_;
};

TEST_F(Calibrated, IsMeasuredOnceAndFoundAgain) {
    const Shot shot = smallBlock(ImpactKind::kDrop);
    const auto body = bodyOf(shot);
    const Calibration first = calibrate(shot, body, {}, {});
    EXPECT_FALSE(first.from_cache);
    EXPECT_GT(first.trials, 3u);
    const Calibration again = calibrate(shot, body, {}, {});
    EXPECT_TRUE(again.from_cache);
    EXPECT_EQ(again.velocity(), first.velocity());
    EXPECT_NEAR(thresholdOf(shot, *body)->measured.value(), first.velocity(), 1e-9);
    EXPECT_FALSE(calibrate(shot, body, {.tolerance = 0.02}, {}).from_cache) << "asked for more exactly";
}

TEST_F(Calibrated, BreaksWhereItWasToldTo) {
    for (const ImpactKind kind : {ImpactKind::kDrop, ImpactKind::kBall}) {
        Shot shot = smallBlock(kind);
        const auto body = bodyOf(shot);
        const double natural = calibrate(shot, body, {.tolerance = 0.03}, {}).velocity();
        // Weaker, not stronger: at twice its threshold this ball comes with 0.4 of the softened wave speed.
        shot.break_at = 0.6 * natural;
        const Calibration told = calibrate(shot, body, {.tolerance = 0.03}, {});
        EXPECT_FALSE(told.from_cache);
        EXPECT_NEAR(told.velocity() / *shot.break_at, 1, 0.10);
        EXPECT_TRUE(told.meetsBreakAt());
        ImpactTrial trial(trialShot(told.shot), body, {});
        EXPECT_FALSE(trial.breaksAt(0.9 * *shot.break_at));
        EXPECT_TRUE(trial.breaksAt(1.1 * *shot.break_at));
        // The same strength again, and the same threshold beside it.
        EXPECT_EQ(criticalVelocityFor(shot, *body, *shot.break_at), told.shot.material.critical_velocity);
        EXPECT_NEAR(thresholdOf(told.shot, *body)->measured.value(), told.velocity(), 1e-9);
        const Calibration again = calibrate(shot, body, {.tolerance = 0.03}, {});
        EXPECT_TRUE(again.from_cache);
        EXPECT_EQ(again.shot.material.critical_velocity, told.shot.material.critical_velocity);
    }
}

TEST_F(Calibrated, TheMeanOfPackingsBreaksWhereItWasToldTo) {
    Shot shot = smallBlock(ImpactKind::kDrop);
    const auto body = bodyOf(shot);
    shot.break_at = 1.3 * thresholdOf(shot, *body)->predicted;
    const Calibration told = calibrate(shot, body, {.packings = 2}, {});
    EXPECT_EQ(told.measured.packings, 2u);
    EXPECT_NEAR(told.velocity() / *shot.break_at, 1, 0.10);
    EXPECT_EQ(criticalVelocityFor(shot, *body, *shot.break_at), told.shot.material.critical_velocity);
}

TEST_F(Calibrated, CancelLeavesNothing) {
    Shot shot = smallBlock(ImpactKind::kDrop);
    const auto body = bodyOf(shot);
    for (const bool told : {false, true}) {
        if (told) shot.break_at = thresholdOf(shot, *body)->predicted;
        EXPECT_THROW(calibrate(shot, body, {}, [](double fraction, const char*) { return fraction < 0.2; }),
                     Cancelled);
        EXPECT_FALSE(thresholdOf(shot, *body)->measured);
    }
}

}  // namespace
}  // namespace demolish
