// SPDX-License-Identifier: Apache-2.0
// Rigid pieces that wake while they press on a floor: they go on with what they have taken in, and with no
// more (architecture 9, physics B.1).
#include <gtest/gtest.h>

#include "sim_cuda/kernels/start_velocities.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Waking : public OnEitherDevice {};

constexpr double kWakesAt = 0.05;  ///< s, or up to three frames before

/// A block that has become rigid lands at 1 m/s after `lands` s, slowly enough to stay so; a ball from above
/// wakes it before it hits it. A contact step is 3.3 ms, a frame.
SceneSetup blockAndBall(double lands) {
    constexpr double kSpeed = 1, kBallSpeed = 8, kHeight = 0.3;
    SceneSetup setup = with(freeBody(latticeBody(3, 3, 3, kHeight / 3)), {true, false});
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 50;
    setup.params.frame_time = 10.0 / (60 * setup.params.substeps);
    BodyInstance& block = setup.bodies[0];
    block.material.critical_velocity = 10;
    block.velocity = {0, -kSpeed, 0};
    block.position = {0, kSpeed * lands, 0};
    Projectile ball;
    ball.radius = 0.03;
    ball.position = {0.01, kHeight + ball.radius + kBallSpeed * (kWakesAt + 0.002), 0};
    ball.velocity = {0, -kBallSpeed, 0};
    setup.projectiles = {ball};
    return setup;
}

/// What it has in the end, less what it had at the start, over that. Something wakes meanwhile.
double energyFound(const SceneSetup& setup) {
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy);
    bool was_rigid = false, wakes = false;
    for (double time = 0; time < kWakesAt + 0.01; time += setup.params.frame_time) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        wakes = wakes || (was_rigid && solver->stats().rigid_fragments == 0);
        was_rigid = solver->stats().rigid_fragments > 0;
    }
    EXPECT_TRUE(wakes);
    solver->measure();
    return energySum(solver->stats().energy) / before - 1;
}

/// Half of the last contact step's kick comes when they wake, and what that changes by physics B.1 is booked.
TEST_F(Waking, KeepsTheEnergyOfABlockThatPressesOnItsFloor) {
    for (int k = 0; k < 20; ++k) {
        const double lands = kWakesAt - 0.001 * k;
        EXPECT_NEAR(energyFound(blockAndBall(lands)), 0, 1e-4) << "lands after " << lands << " s";
    }
}

/// A contact step has driven a cell into the floor, and no contact has seen it yet, when the block beside it
/// wakes; then all are moved with their bonds.
TEST_F(Waking, FindsNoEnergyInWhatHasGoneIntoTheFloorUnseen) {
    constexpr double kSpeed = 20;
    for (int k = 0; k < 20; ++k) {
        const double lands = kWakesAt - 0.006 - 0.0002 * k;
        SceneSetup setup = blockAndBall(kWakesAt + 0.05);
        BodyInstance cell = setup.bodies[0];
        cell.body = ballBody(0.05);
        cell.velocity = {0, -kSpeed, 0};
        cell.position = {1, kSpeed * lands, 0};
        setup.bodies.push_back(cell);
        EXPECT_NEAR(energyFound(setup), 0, 5e-4) << "lands after " << lands << " s";
    }
}

/// Nor in faces of a broken bond: two cells that hardly hang together go slowly apart as they spin, and a
/// third one drives the lower against the upper when the block beside them wakes.
TEST_F(Waking, FindsNoEnergyInFacesThatHaveMetUnseen) {
    constexpr double kSpeed = 3;
    for (int k = 0; k < 20; ++k) {
        const double meets = kWakesAt - 0.01 - 0.0005 * k;
        SceneSetup setup = blockAndBall(kWakesAt + 0.05);
        BodyInstance pair = setup.bodies[0], third = pair;
        pair.body = latticeBody(1, 2, 1, 0.1);
        pair.material.critical_velocity = 0.001;
        pair.velocity = {};
        pair.angular_velocity = {0, 0, 5};
        pair.position = {1, 1, 0};
        third.body = ballBody(0.05);
        third.velocity = {0, kSpeed, 0};
        third.position = {1, 1 - 0.1 - kSpeed * meets, 0};
        setup.bodies.push_back(pair);
        setup.bodies.push_back(third);
        EXPECT_NEAR(energyFound(setup), 0, 1e-3) << "they meet after " << meets << " s";
    }
}

/// Bodies are in no snapshot, and the books are none of the state's business.
TEST_F(Waking, GivesTheSameStateAfterASnapshotAndWithoutBooks) {
    for (const double lands : {kWakesAt - 0.004, kWakesAt - 0.009, kWakesAt - 0.014}) {
        SceneSetup setup = blockAndBall(lands);
        auto solver = makeSolver(setup), other = makeSolver(setup);
        setup.params.ledger = false;
        auto without_books = makeSolver(setup);
        bool was_rigid = false, wakes = false;
        for (int frame = 0; frame < 18; ++frame) {
            other->restore(solver->save());
            for (Solver* each : {solver.get(), other.get(), without_books.get()})
                ASSERT_EQ(each->advanceFrame(), StepStatus::kOk);
            ASSERT_EQ(other->stateHash(), solver->stateHash()) << "frame " << frame;
            ASSERT_EQ(without_books->stateHash(), solver->stateHash()) << "frame " << frame;
            wakes = wakes || (was_rigid && solver->stats().rigid_fragments == 0);
            was_rigid = solver->stats().rigid_fragments > 0;
        }
        EXPECT_TRUE(wakes);
    }
}

/// What was known of it when it was moved with its bonds last must not count: no snapshot has that.
TEST_F(Waking, ASleeperThatWakesWithinAFrameStartsFromRest) {
    const uint32_t bonded = wordOf(Regime::kBonded), own = 0, one = 1;
    PoseSums pose;
    pose.now = massOf(2.0, {}, {3, 0, 0});
    RigidBody body;
    body.velocity = {5, 0, 0};
    for (const Regime before : {Regime::kAsleep, Regime::kRigid, Regime::kBonded}) {
        const uint32_t former = wordOf(before);
        Vec4<float> start{7, 7, 7, 7};
        uint64_t added[2][3] = {{9, 9, 9}, {9, 9, 9}};
        const FragmentRows rows{{&own, 1}, {&own, 1}, {&own, 1}, {&one, 1}};
        const StartVelocities<float> kernel{rows,
                                            {&own, 1},
                                            {&pose, 1},
                                            {},
                                            {},
                                            {&start, 1},
                                            {{added[0], 3}, {added[1], 3}},
                                            {{&bonded, 1}, {&former, 1}, {&body, 1}, false}};
        kernel(0);
        const bool goes_on = before == Regime::kBonded;
        EXPECT_EQ(start.x, goes_on ? 7.0f : before == Regime::kRigid ? 5.0f : 0.0f);
        EXPECT_EQ(start.w, goes_on ? 7.0f : 0.5f);
        EXPECT_EQ(added[0][0], goes_on ? 9u : 0u);
    }
}

}  // namespace
}  // namespace demolish::tests
