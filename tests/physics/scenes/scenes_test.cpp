// SPDX-License-Identifier: Apache-2.0
// One or two bodies of each scene: what the scene promises, at a few hundred particles.
#include <gtest/gtest.h>

#include <string>

#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

class SceneStands : public testing::TestWithParam<const char*> {};

TEST_P(SceneStands, StillUntilItIsHit) {
    Shot shot = smallScene(GetParam(), 400);
    if (!shot.bodies.empty()) shot = smallScene(GetParam(), 400, {0});
    const Standing standing = stand(shot, 0.5);
    EXPECT_EQ(standing.broken, 0u);
    EXPECT_LT(standing.moved, 2e-4);
    EXPECT_LT(standing.speed, 2e-3);
}

/// The wolf is too slender for so few particles: it stands among the slow tests.
INSTANTIATE_TEST_SUITE_P(Scenes, SceneStands, testing::Values("bunny", "vase", "column"),
                         [](const auto& test) { return std::string(test.param); });

struct Breaking {
    const char* scene;
    uint32_t body, least_pieces;
    bool hand_over;
};
std::string nameOf(const Breaking& breaking) {
    return std::string(breaking.scene) + (breaking.hand_over ? "_handed_over" : "_bonds_only");
}
void PrintTo(const Breaking& breaking, std::ostream* out) {
    *out << nameOf(breaking);
}

class SceneBreaks : public testing::TestWithParam<Breaking> {};

TEST_P(SceneBreaks, AndComesToRestWithinThreeSeconds) {
    const auto [scene, body, least_pieces, hand_over] = GetParam();
    Shot shot = smallScene(scene, 400);
    if (!shot.bodies.empty()) shot = smallScene(scene, 400, {body});
    const double hit = shot.balls.empty() ? shot.impact.arrival_time : shot.balls.back().arrival_time;
    shot.hand_over = hand_over;
    SceneRun run(shot);
    run.runTo(hit - 0.01);
    EXPECT_EQ(run.stats().bonds_broken, 0u) << "the ball is not early";
    run.runTo(hit + 0.05);
    EXPECT_GT(run.stats().bonds_broken, 0u) << "nor late";
    run.runTo(hit + 3);
    EXPECT_GE(run.stats().fragments, least_pieces);
    EXPECT_LT(run.stats().largest_fragment_fraction, 0.6);
    EXPECT_LT(run.movingShare(0.02), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneBreaks,
                         testing::Values(Breaking{"bunny", 0, 8, false}, Breaking{"bunny", 0, 8, true},
                                         Breaking{"vase", 6, 10, false}, Breaking{"vase", 13, 10, true}),
                         [](const auto& test) { return nameOf(test.param); });

TEST(Scenes, AColumnBreaksIntoDrums) {
    const Shot shot = smallScene("column", 400, {17});
    SceneRun run(shot);
    run.runTo(shot.balls.back().arrival_time + 1.5);
    EXPECT_GE(run.stats().fragments, 5u);
    EXPECT_LT(run.stats().largest_fragment_fraction, 0.5);
}

TEST(Scenes, OnlyTheBodyThatIsHitBreaks) {
    Shot shot = smallScene("vase", 300, {4, 17});
    const double first = shot.balls.front().arrival_time, second = shot.balls.back().arrival_time;
    ASSERT_EQ(shot.balls.size(), 2u);
    ASSERT_GT(second, first + 0.3);
    SceneRun run(shot);
    const auto start = run.positions();
    run.runTo(first + 0.3);
    EXPECT_GT(run.stats().fragments, 5u);
    EXPECT_GT(run.stats().largest_fragment_fraction, 0.499) << "the other one is whole";
    const auto now = run.positions();
    const std::vector<Float3> untouched_before(start.begin(), start.begin() + 300),
        untouched_now(now.begin(), now.begin() + 300);
    EXPECT_LT(farthest(untouched_before, untouched_now), 1e-3) << "nor moved";
    run.runTo(second + 0.3);
    EXPECT_LT(run.stats().largest_fragment_fraction, 0.49);
}

TEST(Scenes, AnArchStandsWithoutMortarUntilItsKeystoneIsShot) {
    Shot shot = smallScene("arch", 60);
    bringForward(shot, {1.0, 1.0});
    SceneRun run(shot);
    const auto start = run.positions();
    run.runTo(0.9);
    EXPECT_EQ(run.stats().bonds_broken, 0u);
    EXPECT_LT(farthest(start, run.positions()), 5e-3);
    run.runTo(2);
    EXPECT_GT(run.stats().bonds_broken, 0u);
    EXPECT_GT(farthest(start, run.positions()), 0.5);
}

TEST(Scenes, AtVelocityZeroNothingIsHit) {
    Shot shot = smallScene("vase", 200, {4, 17});
    shot.impact.velocity = 0;
    SceneRun run(shot);
    run.runTo(shot.balls.back().arrival_time + 0.2);
    EXPECT_EQ(run.stats().bonds_broken, 0u);
    EXPECT_EQ(run.stats().fragments, 2u);
}

/// Four hundred sleeping bricks: what is hit wakes after the ball has been made ready to hit it.
TEST(Scenes, ABallDoesNotHangBeforeWhatSleepsAndMortarHoldsUntilThen) {
    SceneRun run(smallScene("wall", 24));
    run.runTo(0.4);
    EXPECT_EQ(run.stats().fragments, 1u);
    run.runTo(0.75);
    EXPECT_GT(run.stats().bonds_broken, 0u);
    EXPECT_GT(run.stats().fragments, 5u);
}

}  // namespace
}  // namespace demolish::tests
