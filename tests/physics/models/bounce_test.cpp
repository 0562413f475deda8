// SPDX-License-Identifier: Apache-2.0
// What comes back of the speed at which a block falls, flat, on an edge and on a corner (models.md E.4).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/physics/models/packed_body.h"
#include "tests/physics/models/shots.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Bounce : public OnEitherDevice {};

constexpr double kRestitution = 0.1;
struct Fall {
    const char* name;
    Double3 tilt;
};
constexpr Fall kFalls[] = {{"flat", {}}, {"edge", {0, 0, 0.785398}}, {"corner", {0.615480, 0, 0.785398}}};

SceneSetup falling(uint32_t cells, const Fall& fall, double speed, double critical_velocity) {
    Material material = sheetMaterial(critical_velocity, 0);
    material.restitution = kRestitution;
    SceneSetup setup = dropped(boxBody({1, 1, 1}, cells, 5), material, 150, fall.tilt, speed);
    setup.params.gravity = {0, -9.81, 0};
    setup.params.frame_time = 1.0 / 240;
    setup.params.ledger = true;
    // Long enough in the air that its bonds come to rest first, where they may.
    const double before = 0.05, start = speed - 9.81 * before;
    setup.bodies[0].velocity.y = -start;
    setup.bodies[0].position.y += start * before + 0.5 * 9.81 * before * before;
    return setup;
}

struct Rise {
    double share = 0;    ///< highest speed upwards after the hit, over the highest downwards
    double closure = 0;  ///< energy that there is and went, over that at the start
    uint32_t broken = 0;
};

Rise riseOf(const SceneSetup& setup) {
    auto solver = makeSolver(setup);
    solver->measure();
    const double at_first = energySum(solver->stats().energy);
    double lowest = 0, highest = 0;
    for (int frame = 0; frame < 108; ++frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const double v = solver->stats().linear_momentum.y / solver->stats().mass;
        if (v < lowest) {
            lowest = v;
            highest = 0;
        }
        highest = std::max(highest, v);
    }
    return {highest / -lowest, energySum(solver->stats().energy) / at_first, solver->stats().bonds_broken};
}

/// So tough that nothing wakes its bonds.
TEST_F(Bounce, OfRigidBlocksIsWhatTheMaterialSaysAtAnySpeed) {
    for (const uint32_t cells : {2u, 8u, 64u, 512u, 4096u})
        for (const Fall& fall : kFalls)
            for (const double speed : {1.0, 3.0}) {
                SceneSetup setup = falling(cells, fall, speed, 1e4);
                setup.params.hand_over = true;
                const Rise rise = riseOf(setup);
                std::printf("%4u cells, %-6s at %.0f m/s: %.3f, energy %.4f\n", cells, fall.name, speed,
                            rise.share, rise.closure);
                EXPECT_EQ(rise.broken, 0u);
                EXPECT_NEAR(rise.share, kRestitution, 0.1)
                    << cells << " cells, " << fall.name << ", " << speed;
                EXPECT_NEAR(rise.closure, 1, 0.02) << cells << " cells, " << fall.name << ", " << speed;
            }
}

/// m/s, ceramic's: what comes slower breaks nothing.
constexpr double kGentle = 0.6 * 0.4 * 5;

TEST_F(Bounce, OfBondedBlocksIsTheSameWhereNothingCanBreak) {
    for (const uint32_t cells : {2u, 8u, 64u, 512u})
        for (const Fall& fall : {kFalls[0], kFalls[1]})
            for (const double speed : {0.4 * kGentle, 0.8 * kGentle}) {
                const Rise rise = riseOf(falling(cells, fall, speed, 5));
                std::printf("%4u bonded cells, %-6s at %.2f m/s: %.3f, energy %.4f\n", cells, fall.name,
                            speed, rise.share, rise.closure);
                EXPECT_EQ(rise.broken, 0u);
                EXPECT_NEAR(rise.share, kRestitution, 0.11)
                    << cells << " cells, " << fall.name << ", " << speed;
                EXPECT_NEAR(rise.closure, 1, 0.002) << cells << " cells, " << fall.name << ", " << speed;
            }
}

/// What comes faster may break, so that its floor is hard until it has come to a stop: of a wave that is then
/// on its way through the block no floor law takes more.
TEST_F(Bounce, OfBondedBlocksIsLessThanHalfOfAFastLanding) {
    for (const uint32_t cells : {2u, 8u, 64u, 512u})
        for (const Fall& fall : kFalls) {
            const Rise rise = riseOf(falling(cells, fall, 3, 5));
            std::printf("%4u bonded cells, %-6s at 3 m/s: %.3f, energy %.4f, broken %u\n", cells, fall.name,
                        rise.share, rise.closure, rise.broken);
            EXPECT_LT(rise.share, 0.45) << cells << " cells, " << fall.name;
            EXPECT_NEAR(rise.closure, 1, 0.002) << cells << " cells, " << fall.name;
        }
}

}  // namespace
}  // namespace demolish::tests
