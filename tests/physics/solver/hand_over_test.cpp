// SPDX-License-Identifier: Apache-2.0
// Fragments that are handed over to rigid motion end as they do with their bonds (architecture 9).
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class HandOver : public OnEitherDevice {};

struct Outcome {
    FrameStats stats;
    uint64_t hash = 0;
    uint32_t most_rigid = 0, most_asleep = 0;
};

Outcome run(const SceneSetup& setup, int frames) {
    auto solver = makeSolver(setup);
    Outcome outcome;
    for (int frame = 0; frame < frames; ++frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        outcome.most_rigid = std::max(outcome.most_rigid, solver->stats().rigid_fragments);
        outcome.most_asleep = std::max(outcome.most_asleep, solver->stats().sleeping_fragments);
    }
    solver->measure();
    outcome.stats = solver->stats();
    outcome.hash = solver->stateHash();
    return outcome;
}

/// Means over three runs whose balls start 1 um apart: single ones differ by 3 % (1020 to 1058 bonds).
struct Means {
    double broken = 0, fragments = 0, largest = 0, energy = 0, damping = 0, friction = 0, fracture = 0;
};
Means meansOf(const Regimes& regimes) {
    constexpr int kRuns = 4;
    Means means;
    for (int k = 0; k < kRuns; ++k) {
        SceneSetup setup = with(breakingScene(), regimes);
        setup.projectiles[0].position.x += 1e-6 * k;
        const Outcome outcome = run(setup, 90);
        EXPECT_EQ(outcome.most_rigid > 100, regimes.hand_over);
        EXPECT_EQ(outcome.most_asleep > 20, regimes.sleeping);
        if (regimes.sleeping) {
            EXPECT_LT(outcome.stats.awake_particles, 640u);
        }
        means.broken += outcome.stats.bonds_broken / double(kRuns);
        means.fragments += outcome.stats.fragments / double(kRuns);
        means.largest += outcome.stats.largest_fragment_fraction / kRuns;
        const EnergyLedger& e = outcome.stats.energy;
        means.energy += energySum(e) / kRuns;
        means.damping += e.damping / kRuns;
        means.friction += e.friction / kRuns;
        means.fracture += e.fracture / kRuns;
    }
    return means;
}

TEST_F(HandOver, NeitherFragmentsNorLedgerTellWhetherItWasOn) {
    const Means off = meansOf({false, false}), on = meansOf({true, true});
    EXPECT_NEAR(on.broken, off.broken, 0.02 * off.broken);
    EXPECT_NEAR(on.fragments, off.fragments, 0.06 * off.fragments);
    EXPECT_NEAR(on.largest, off.largest, 0.02);
    EXPECT_NEAR(on.energy, off.energy, 2e-3 * off.energy);
    EXPECT_NEAR(on.damping, off.damping, 0.05 * off.damping);
    EXPECT_NEAR(on.friction, off.friction, 0.05 * off.friction);
    EXPECT_NEAR(on.fracture, off.fracture, 0.02 * off.fracture);
}

TEST_F(HandOver, ADroppedBrickComesToRestAndSleeps) {
    SceneSetup setup = with(breakingScene(), {true, true});
    setup.projectiles.clear();
    setup.bodies[0].position.y = 0.4;
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 300; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    EXPECT_GT(solver->stats().bonds_broken, 100u);
    EXPECT_GT(solver->stats().sleeping_fragments, solver->stats().fragments * 3 / 4);
    EXPECT_EQ(solver->stats().bonded_particles, 0u);
}

TEST_F(HandOver, TwoRunsGiveTheSameBits) {
    const SceneSetup setup = with(breakingScene(), {true, true});
    EXPECT_EQ(run(setup, 30).hash, run(setup, 30).hash);
}

}  // namespace
}  // namespace demolish::tests
