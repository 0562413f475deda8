// SPDX-License-Identifier: Apache-2.0
// What a session keeps when another scene or model is asked for and does not come, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "app/session/scene_file.h"
#include "app/session/session.h"
#include "app/session/threshold.h"

namespace demolish {
namespace {

constexpr double kLater = 1;  // s, longer than a change rests before its rebuild starts

Shot smallBlock() {
    Shot shot = loadScene("block");
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = 60;
    return shot;
}

void waitForRebuild(Session& session) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    do {
        if (std::chrono::steady_clock::now() > patience) throw std::runtime_error("the rebuild does not end");
        session.update(kLater, false);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (session.status().waiting || session.status().rebuilding);
    session.update(kLater, false);
}

class SessionTest : public testing::Test {
  protected:
    SessionTest() {
        chosen_.impact.velocity = 40;
        chosen_.lighting.exposure = 0.5f;
        session_.apply(command::ChangeShot{chosen_}, 0);
    }
    void expectTheChosenShot() const {
        const Shot& shot = session_.shot();
        EXPECT_EQ(shot.model, chosen_.model);
        EXPECT_EQ(shot.impact.velocity, 40);
        EXPECT_EQ(shot.impact.ball_radius, smallBlock().impact.ball_radius);
        EXPECT_EQ(shot.impact.direction.x, smallBlock().impact.direction.x);
        EXPECT_EQ(shot.impact.height_fraction, smallBlock().impact.height_fraction);
        EXPECT_EQ(shot.lighting.exposure, 0.5f);
        EXPECT_EQ(changeBetween(shot, chosen_), Change::kNothing);
    }

    Shot chosen_ = smallBlock();
    Session session_{buildShot(smallBlock(), {}, {}), {.draw = false}};
};

TEST_F(SessionTest, AModelThatCannotBeReadLeavesTheShotAsItWas) {
    Shot other;
    other.model = "/no/such/file.obj";
    other.device = DeviceChoice::kCpu;
    session_.apply(command::ChangeShot{other}, 0);
    other.impact.velocity = 7;  // and the slider moved meanwhile
    session_.apply(command::ChangeShot{other}, 0);
    waitForRebuild(session_);
    EXPECT_THAT(session_.status().message, testing::HasSubstr("/no/such/file.obj"));
    expectTheChosenShot();
}

TEST_F(SessionTest, ASceneThatIsCancelledLeavesTheShotAsItWas) {
    Shot other = loadScene("bunny");
    other.device = DeviceChoice::kCpu;
    session_.apply(command::ChangeShot{other}, 0);
    session_.update(kLater, false);
    ASSERT_TRUE(session_.status().rebuilding);
    session_.apply(command::CancelRebuild{}, kLater);
    expectTheChosenShot();
}

TEST_F(SessionTest, AModelThatComesBringsItsOwnImpact) {
    Shot other = smallBlock();
    other.scene = "model";
    other.model = other.model.parent_path() / "column_paper.obj";
    other.impact.ball_radius = 0;
    session_.apply(command::ChangeShot{other}, 0);
    waitForRebuild(session_);
    EXPECT_EQ(session_.built().shot.model, other.model);
    EXPECT_EQ(session_.shot().impact.ball_radius, 0);
    Shot third = other;
    third.model = "/no/such/file.obj";
    third.impact.ball_radius = 0.3;
    session_.apply(command::ChangeShot{third}, 0);
    waitForRebuild(session_);
    EXPECT_EQ(session_.shot().impact.ball_radius, 0) << "that of the model on screen";
}

TEST_F(SessionTest, AModelIsHitWithAMultipleOfItsPredictedThreshold) {
    Shot other = smallBlock();
    other.scene = "model";
    other.impact.times_threshold = 2;
    session_.apply(command::ChangeShot{other}, 0);
    waitForRebuild(session_);
    const Shot& shot = session_.shot();
    const double predicted = thresholdOf(shot, *session_.built().body)->predicted;
    EXPECT_NEAR(shot.impact.velocity, 2 * predicted, 0.05 * 2 * predicted) << "two digits of it";
    EXPECT_FALSE(shot.impact.times_threshold);
    EXPECT_LE(changeBetween(shot, session_.built().shot), Change::kLive) << "nothing to build for it";

    Shot asked = shot;
    asked.break_at = 6;
    asked.impact.times_threshold = 1.5;
    EXPECT_DOUBLE_EQ(buildShot(asked, {}, {}).shot.impact.velocity, 9);
    asked.impact.kind = ImpactKind::kNone;
    asked.break_at.reset();
    EXPECT_EQ(buildShot(asked, {}, {}).shot.impact.velocity, shot.impact.velocity) << "nothing hits it";
}

/// Or the same shot would end otherwise in a window than without one.
TEST(SessionOfFewSubsteps, AMuchFasterBallTakesTheSubstepsOfAShotBuiltForIt) {
    Shot slow = smallBlock(), faster = slow, fast = slow;
    for (Shot* shot : {&slow, &faster, &fast}) shot->substeps = 20;
    slow.impact.velocity = 1;
    faster.impact.velocity = 1.5;
    fast.impact.velocity = 150;
    Session session(buildShot(slow, {}, {}), {.draw = false}),
        meant(buildShot(fast, {}, {}), {.draw = false});
    const uint32_t few = session.built().setup.params.substeps;
    session.apply(command::ChangeShot{faster}, 0);
    EXPECT_FALSE(session.status().waiting) << "as live as ever";
    session.apply(command::ChangeShot{fast}, 0);
    waitForRebuild(session);
    EXPECT_GT(session.built().setup.params.substeps, few);
    EXPECT_EQ(session.built().setup.params.substeps, meant.built().setup.params.substeps);
    for (Session* each : {&session, &meant})
        for (int frame = 0; frame < 40; ++frame) ASSERT_EQ(each->advance(), StepStatus::kOk);
    EXPECT_GT(meant.solver().stats().bonds_broken, 0u);
    EXPECT_EQ(session.solver().stateHash(), meant.solver().stateHash());
    session.apply(command::ChangeShot{slow}, 0);
    waitForRebuild(session);
    EXPECT_EQ(session.built().setup.params.substeps, few);
}

TEST_F(SessionTest, EnergyIsBookedOnlyWhileItIsAskedForWhereNoReportNeedsIt) {
    Session session(buildShot(smallBlock(), {.ledger = false}, {}), {.draw = false});
    const auto advance = [&](int frames) {
        for (int frame = 0; frame < frames; ++frame) ASSERT_EQ(session.advance(), StepStatus::kOk);
    };
    advance(2);
    EXPECT_FALSE(session.solver().booksEnergy());
    EXPECT_FALSE(session.status().energy);
    session.apply(command::MeasureEnergy{true}, 0);
    EXPECT_TRUE(session.solver().booksEnergy());
    advance(2);
    ASSERT_TRUE(session.status().energy);
    EXPECT_GT(session.status().energy->since, 0);
    session.apply(command::Reset{}, 0);
    advance(2);
    ASSERT_TRUE(session.status().energy);
    EXPECT_EQ(session.status().energy->since, 0);
    session.apply(command::MeasureEnergy{false}, 0);
    EXPECT_FALSE(session.solver().booksEnergy());
}

/// A frame of it takes any machine much longer than a turn of the window.
Shot longFrames() {
    Shot shot = smallBlock();
    shot.fineness.particles = 500;
    shot.fps = 1;
    shot.substeps = 20000;
    return shot;
}

TEST(LongFrame, IsSpreadOverTheTurnsOfTheWindow) {
    Session session(buildShot(longFrames(), {}, {}), {.draw = false});
    const uint64_t start = session.solver().stateHash();
    session.apply(command::Play{}, 0);
    session.update(0);
    ASSERT_TRUE(session.frameUnderWay());
    double share = *session.frameUnderWay();
    session.update(0, false);
    ASSERT_GT(*session.frameUnderWay(), share) << "what has begun goes on, though no new frame is due";
    EXPECT_EQ(session.status().frame_share, session.frameUnderWay());
    EXPECT_EQ(session.status().stats.frame, 0u);

    session.apply(command::Pause{}, 0);
    share = *session.frameUnderWay();
    session.update(0);
    EXPECT_EQ(*session.frameUnderWay(), share) << "paused, it waits";
    session.apply(command::Step{}, 0);
    EXPECT_GT(*session.frameUnderWay(), share) << "and goes on";
    EXPECT_TRUE(session.playing()) << "until the step is done";
    session.apply(command::TogglePlay{}, 0);
    EXPECT_FALSE(session.playing());

    EXPECT_EQ(session.solver().stateHash(), start) << "given up, it leaves the frame before";
    EXPECT_FALSE(session.frameUnderWay());
}

TEST(LongFrame, IsGivenUpForWhatNeedsTheSolver) {
    Session session(buildShot(longFrames(), {}, {}), {.draw = false});
    const std::vector<command::Any> needing = {command::Fire{}, command::Reset{},
                                               command::MeasureEnergy{true}};
    for (const command::Any& command : needing) {
        session.apply(command::Play{}, 0);
        session.update(0);
        ASSERT_TRUE(session.frameUnderWay());
        session.apply(command, 0);
        EXPECT_FALSE(session.frameUnderWay());
        EXPECT_EQ(session.status().stats.frame, 0u);
    }
}

TEST(LongFrame, InSlicesItIsTheSame) {
    Session sliced(buildShot(smallBlock(), {}, {}), {.draw = false}),
        whole(buildShot(smallBlock(), {}, {}), {.draw = false});
    for (uint64_t frame = 1; frame <= 12; ++frame) {
        do {
            ASSERT_EQ(sliced.advance([](double) { return false; }), StepStatus::kOk);
            EXPECT_EQ(sliced.status().stats.frame, sliced.frameUnderWay() ? frame - 1 : frame);
        } while (sliced.frameUnderWay());
        ASSERT_EQ(whole.advance(), StepStatus::kOk);
        ASSERT_EQ(sliced.solver().stateHash(), whole.solver().stateHash());
    }
    EXPECT_GT(whole.status().stats.bonds_broken, 0u);
}

TEST_F(SessionTest, AClickShootsNothingAtVelocityZero) {
    const command::ShootAt click{{0, 1, 3}, {0, 0.5, 1}};
    chosen_.impact.velocity = 0;
    session_.apply(command::ChangeShot{chosen_}, 0);
    session_.apply(click, 0);
    EXPECT_THAT(session_.status().message, testing::HasSubstr("velocity is 0"));
    EXPECT_FALSE(session_.status().playing);
    chosen_.impact.velocity = 5;
    session_.apply(command::ChangeShot{chosen_}, 0);
    session_.apply(click, 0);
    EXPECT_EQ(session_.status().message, "");
    EXPECT_TRUE(session_.status().playing);
}

TEST_F(SessionTest, ABallThatWouldStartInsideTheBodyStartsFartherBackAndASentenceSaysSo) {
    chosen_.impact.velocity = 5;
    session_.apply(command::ChangeShot{chosen_}, 0);
    session_.apply(command::ShootAt{{0, 1, 3}, {0, 0.5, 0}}, 0);
    EXPECT_THAT(session_.status().message, testing::HasSubstr("farther back on its way"));
    EXPECT_TRUE(session_.status().playing);
}

}  // namespace
}  // namespace demolish
