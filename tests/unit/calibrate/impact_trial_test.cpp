// Real trials on a small block: the solver decides what breaks.
#include "app/calibrate/impact_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/calibrate/calibration.h"
#include "app/session/scene_file.h"
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
        // The same strength again, and the same threshold beside it.
        EXPECT_NEAR(criticalVelocityFor(shot, *body, told.velocity()) / told.shot.material.critical_velocity,
                    1, 1e-6);
        EXPECT_NEAR(thresholdOf(told.shot, *body)->measured.value(), told.velocity(), 1e-9);
    }
}

TEST_F(Calibrated, CancelLeavesNothing) {
    const Shot shot = smallBlock(ImpactKind::kDrop);
    const auto body = bodyOf(shot);
    EXPECT_THROW(calibrate(shot, body, {}, [](double fraction, const char*) { return fraction < 0.2; }),
                 Cancelled);
    EXPECT_FALSE(thresholdOf(shot, *body)->measured);
}

}  // namespace
}  // namespace demolish
