// SPDX-License-Identifier: Apache-2.0
// Projectiles on the host: when each starts, what it brings in, where it waits.
#include "sim_cuda/solver/projectiles.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim_cuda/api/errors.h"

namespace demolish::tests {
namespace {

constexpr double kStep = 1e-3;
constexpr Double3 kGravity{0, -10, 0};

Projectile startingAt(double time) {
    Projectile shot;
    shot.position = {1, 2, 3};
    shot.velocity = {4, 0, 0};
    shot.start_time = time;
    return shot;
}

/// Those that are due, where the list has them.
std::vector<uint32_t> startDue(Projectiles& projectiles, uint64_t substep) {
    const std::vector<uint32_t> due = projectiles.due(substep);
    for (const uint32_t slot : due) projectiles.start(slot, projectiles.all()[slot]);
    return due;
}

TEST(Projectiles, EachStartsAtTheFirstSubstepThatIsNotBeforeItsTime) {
    Projectiles projectiles({startingAt(0.0051), startingAt(0.002), startingAt(0)}, kGravity, kStep);
    EXPECT_EQ(projectiles.nextStart(), 0u);
    EXPECT_EQ(startDue(projectiles, 0), std::vector<uint32_t>{2});
    EXPECT_EQ(projectiles.nextStart(), 2u);
    EXPECT_TRUE(startDue(projectiles, 1).empty());
    EXPECT_EQ(startDue(projectiles, 2), std::vector<uint32_t>{1});
    EXPECT_TRUE(startDue(projectiles, 2).empty()) << "none starts twice";
    EXPECT_EQ(projectiles.nextStart(), 6u);
    EXPECT_EQ(startDue(projectiles, 10), std::vector<uint32_t>{0});
    EXPECT_EQ(projectiles.nextStart(), ~uint64_t{0});
}

TEST(Projectiles, SeveralThatAreDueStartInTheOrderOfTheirSlots) {
    Projectiles projectiles({startingAt(0.003), startingAt(0.001)}, kGravity, kStep);
    EXPECT_EQ(startDue(projectiles, 3), (std::vector<uint32_t>{0, 1}));
}

TEST(Projectiles, OnlyThoseThatComeLaterPutInWork) {
    const Projectile at_once = startingAt(0), later = startingAt(0.001);
    Projectiles projectiles({at_once, later}, kGravity, kStep);
    startDue(projectiles, 0);
    EXPECT_EQ(projectiles.work(), 0);
    projectiles.begin();
    startDue(projectiles, 1);
    const double mass = projectileMass(later);  // kinetic 8 J/kg, 2 m above the origin at 10 m/s^2
    EXPECT_NEAR(projectiles.work(), mass * (8 + 20), 1e-9 * mass);
}

TEST(Projectiles, OneThatIsPlacedElsewhereIsBookedThere) {
    Projectile waiting = startingAt(0), placed = waiting;
    placed.position.y = 5;
    Projectiles projectiles({waiting}, kGravity, kStep);
    projectiles.begin();
    projectiles.start(0, placed);
    EXPECT_EQ(projectiles.all()[0].position.y, 5);
    EXPECT_NEAR(projectiles.work(), projectileMass(placed) * (8 + 50), 1e-9 * projectileMass(placed));
}

TEST(Projectiles, OneThatIsFiredStartsNow) {
    Projectiles projectiles({}, kGravity, kStep);
    projectiles.fire(startingAt(99), 7);
    EXPECT_DOUBLE_EQ(projectiles.all()[0].start_time, 0.007);
    EXPECT_EQ(startDue(projectiles, 7), std::vector<uint32_t>{0});
}

TEST(Projectiles, BadOnesAndTooManyAreRefusedAndLeaveTheListAsItWas) {
    Projectiles projectiles({}, kGravity, kStep);
    Projectile flat = startingAt(0);
    flat.radius = 0;
    EXPECT_THROW(projectiles.fire(flat, 0), UsageError);
    EXPECT_TRUE(projectiles.all().empty());
    for (uint32_t k = 0; k < kMaxProjectiles; ++k) projectiles.fire(startingAt(0), 0);
    EXPECT_THROW(projectiles.fire(startingAt(0), 0), UsageError);
    EXPECT_EQ(projectiles.all().size(), kMaxProjectiles);
    EXPECT_EQ(startDue(projectiles, 0).size(), kMaxProjectiles);
}

TEST(Projectiles, OneThatWaitsIsOnItsWayToWhereItStarts) {
    const Projectiles projectiles({startingAt(0.5)}, kGravity, kStep);
    EXPECT_DOUBLE_EQ(projectiles.waitingAt(0, 0.25).x, 0);
    EXPECT_DOUBLE_EQ(projectiles.waitingAt(0, 0.25).y, 2);
    EXPECT_DOUBLE_EQ(projectiles.waitingAt(0, 0.75).x, 1) << "after its start it is where it started";
}

TEST(Projectiles, AStateThatIsResumedForgetsWhatStartedAfterIt) {
    Projectiles projectiles({startingAt(0.001), startingAt(0.002)}, kGravity, kStep);
    startDue(projectiles, 1);
    const Projectiles::State state = projectiles.state();
    startDue(projectiles, 2);
    projectiles.resume(state);
    EXPECT_EQ(projectiles.nextStart(), 2u);
    EXPECT_EQ(projectiles.work(), state.work);
    EXPECT_EQ(startDue(projectiles, 2), std::vector<uint32_t>{1});
}

}  // namespace
}  // namespace demolish::tests
