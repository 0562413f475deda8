// SPDX-License-Identifier: Apache-2.0
// CPU and GPU, step by step: the same bits through 2,000 breaking substeps, for any number of threads a
// particle.
#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <cstdlib>

#include "tests/determinism/stored_hashes.h"
#include "tests/parity/on_the_gpu.h"
#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/collider_meshes.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/set_scenes.h"

namespace demolish::tests {
namespace {

class Parity : public OnTheGpu {
  protected:
    void TearDown() override { unsetenv("DEMOLISH_THREADS_PER_PARTICLE"); }
};

std::vector<std::string> asText(const std::vector<uint64_t>& hashes) {
    std::vector<std::string> text;
    for (const uint64_t hash : hashes) text.push_back(asHex(hash));
    return text;
}

TEST_F(Parity, TheGpuGivesTheStoredBitsForAnyNumberOfThreadsAParticle) {
    for (const char* threads : {"4-alone", "4", "8", "16"}) {
        setenv("DEMOLISH_THREADS_PER_PARTICLE", threads, 1);
        auto solver = makeCudaSolver(breakingScene());
        EXPECT_EQ(asText(hashesOf(*solver)), storedHashes("breaking_brick"))
            << threads << " threads a particle";
        EXPECT_GT(solver->stats().bonds_broken, 300u);
    }
}

TEST_F(Parity, HertzContactsAndThePapersBondLaw) {
    SceneSetup setup = breakingScene();
    setup.params.contact_law = ContactLaw::kHertz;
    setup.bodies[0].material.bond_law = BondLaw::kPaper;
    setup.bodies[0].material.adhesion_energy = 0.1;
    EXPECT_EQ(asText(hashesOf(*makeCudaSolver(setup))), storedHashes("breaking_brick_paper"));
}

TEST_F(Parity, WhatIsHeldLedInMortarAndDryGivesTheStoredBits) {
    EXPECT_EQ(asText(hashesOf(*makeCudaSolver(heldScene()))), storedHashes("held_and_led"));
    EXPECT_EQ(asText(hashesOf(*makeCudaSolver(mortarScene()))), storedHashes("mortar"));
    EXPECT_EQ(asText(hashesOf(*makeCudaSolver(dryScene()))), storedHashes("dry"));
}

TEST_F(Parity, HeldMortaredAndDryFragmentsAreHandedOverAndSleepAlike) {
    for (SceneSetup setup : {heldScene(), mortarScene(), dryScene()}) {
        setup.params.hand_over = setup.params.sleeping = true;
        auto cpu = makeCpuSolver(setup), gpu = makeCudaSolver(setup);
        uint32_t most_rigid = 0;
        for (int frame = 0; frame < 60; ++frame) {
            ASSERT_EQ(cpu->advanceFrame(), StepStatus::kOk);
            ASSERT_EQ(gpu->advanceFrame(), StepStatus::kOk);
            ASSERT_EQ(gpu->stateHash(), cpu->stateHash()) << "frame " << frame;
            most_rigid = std::max(most_rigid, cpu->stats().rigid_fragments);
        }
        EXPECT_GT(most_rigid, 0u);
        EXPECT_GT(cpu->stats().bonds_broken, 20u);
    }
}

TEST_F(Parity, FramesShotsSnapshotsAndSettlingAgree) {
    SceneSetup setup = breakingScene();
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {0.6, 0, 0.1};
    setup.bodies[1].rotation = {};
    setup.bodies[1].velocity = setup.bodies[1].angular_velocity = {};
    setup.bodies[0].velocity = {8, -2, 0};
    setup.params.settle_time = 0.02;
    auto cpu = makeCpuSolver(setup), gpu = makeCudaSolver(setup);
    Projectile shot;
    shot.radius = 0.04;
    shot.position = {0.6, 0.25, 0.5};
    shot.velocity = {0, 0, -15};
    for (int frame = 0; frame < 8; ++frame) {
        if (frame == 3) {
            cpu->fire(shot);
            gpu->fire(shot);
        }
        if (frame == 5) gpu->restore(cpu->save());
        ASSERT_EQ(cpu->advanceFrame(frame % 2 == 0 ? 1 : 0.37), StepStatus::kOk);
        ASSERT_EQ(gpu->advanceFrame(frame % 2 == 0 ? 1 : 0.37), StepStatus::kOk);
        ASSERT_EQ(gpu->stateHash(), cpu->stateHash()) << "frame " << frame;
        EXPECT_EQ(gpu->stats().bonds_broken, cpu->stats().bonds_broken);
        EXPECT_EQ(gpu->stats().fragments, cpu->stats().fragments);
    }
}

TEST_F(Parity, HandedOverAndSleepingFragmentsMoveAlike) {
    SceneSetup setup = breakingScene();
    setup.params.hand_over = setup.params.sleeping = true;
    auto cpu = makeCpuSolver(setup), gpu = makeCudaSolver(setup);
    uint32_t most_rigid = 0, most_asleep = 0, apart = 0;
    for (int frame = 0; frame < 90; ++frame) {
        if (frame == 20) gpu->restore(cpu->save());
        ASSERT_EQ(cpu->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(gpu->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(gpu->stateHash(), cpu->stateHash()) << "frame " << frame;
        ASSERT_EQ(gpu->stats().bonded_particles, cpu->stats().bonded_particles) << "frame " << frame;
        most_rigid = std::max(most_rigid, cpu->stats().rigid_fragments);
        most_asleep = std::max(most_asleep, cpu->stats().sleeping_fragments);
        const FrameStats& stats = cpu->stats();
        apart += stats.bonded_particles > 0 && stats.rigid_fragments > 0 && stats.carried_particles == 0;
    }
    EXPECT_GT(most_rigid, 50u);
    EXPECT_GT(most_asleep, 5u);
    EXPECT_GT(apart, 3u);  // frames in which bonds and rigid fragments go side by side
}

TEST_F(Parity, PresetPiecesComeApartAndMoveAlike) {
    for (const bool at_impact : {false, true})
        for (const Pattern pattern :
             {Pattern::kUniform, Pattern::kRadial, Pattern::kSlabs, Pattern::kBricks, Pattern::kSplinters}) {
            SceneSetup setup = breakingScene();
            setup.params.hand_over = setup.params.sleeping = true;
            setup.params.preset_pieces = {pattern, at_impact};
            auto cpu = makeCpuSolver(setup), gpu = makeCudaSolver(setup);
            for (int frame = 0; frame < 30; ++frame) {
                ASSERT_EQ(cpu->advanceFrame(), StepStatus::kOk);
                ASSERT_EQ(gpu->advanceFrame(), StepStatus::kOk);
                ASSERT_EQ(gpu->stateHash(), cpu->stateHash()) << "frame " << frame;
                ASSERT_EQ(gpu->stats().fragments, cpu->stats().fragments) << "frame " << frame;
            }
            EXPECT_GT(cpu->stats().fragments, 3u);
            EXPECT_EQ(gpu->stats().bonded_particles, 0u);
        }
}

void expectMovesAlikeOn(const Collider& collider) {
    SceneSetup setup = breakingScene();
    setup.params.hand_over = setup.params.sleeping = true;
    setup.bodies[0].position.y = 0.4;
    setup.projectiles[0].position.y += 0.28;
    setup.params.colliders.push_back(collider);
    auto cpu = makeCpuSolver(setup), gpu = makeCudaSolver(setup);
    for (int frame = 0; frame < 90; ++frame) {
        ASSERT_EQ(cpu->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(gpu->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(gpu->stateHash(), cpu->stateHash()) << "frame " << frame;
    }
    EXPECT_GT(cpu->stats().bonds_broken, 100u);
}

TEST_F(Parity, WhatBreaksOnATurnedBoxMovesAlike) {
    const double turn = 0.3;
    expectMovesAlikeOn(Box{{0.5, 0.2, 0.4}, {0.1, 0.1, 0}, {0, 0, std::sin(turn / 2), std::cos(turn / 2)}});
}

TEST_F(Parity, WhatBreaksOnASphereOrACapsuleMovesAlike) {
    expectMovesAlikeOn(Sphere{0.2, {0.1, 0.05, 0}});
    Collider rod = Capsule{0.1, {-0.2, 0.15, 0.1}, {0.4, 0.1, -0.1}};
    rod.friction = 0.1;
    rod.restitution = 0.7;
    expectMovesAlikeOn(rod);
}

TEST_F(Parity, WhatBreaksOnAMeshMovesAlike) {
    expectMovesAlikeOn(
        meshShape(test::makeTorus(0.2, 0.08, 24, 12), {0.05, 0.12, 0}, {0.1, 0.2, 0.3, 0.9273618495495703}));
}

TEST_F(Parity, SumsAgreeToRoundOff) {
    auto cpu = makeCpuSolver(breakingScene()), gpu = makeCudaSolver(breakingScene());
    for (int frame = 0; frame < 3; ++frame) {
        ASSERT_EQ(cpu->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(gpu->advanceFrame(), StepStatus::kOk);
    }
    cpu->measure();
    gpu->measure();
    const EnergyLedger &a = cpu->stats().energy, &b = gpu->stats().energy;
    EXPECT_NEAR(a.kinetic / b.kinetic, 1, 1e-12);
    EXPECT_NEAR(a.elastic / b.elastic, 1, 1e-12);
    EXPECT_NEAR(a.damping / b.damping, 1, 1e-4);
    EXPECT_NEAR(a.friction / b.friction, 1, 1e-4);
    EXPECT_NEAR(a.fracture / b.fracture, 1, 1e-4);
    EXPECT_EQ(cpu->stats().max_stress_ratio, gpu->stats().max_stress_ratio);
}

TEST_F(Parity, ABadStepLeavesTheFrameBeforeOnTheGpuToo) {
    auto solver = makeCudaSolver(freeBody(latticeBody(3, 3, 3, 0.1)));
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    Projectile shot;
    shot.position = {-0.3, 0.15, 0};
    shot.velocity = {1e20, 0, 0};
    solver->fire(shot);
    const uint64_t before = solver->stateHash();
    EXPECT_TRUE(has(solver->advanceFrame(), StepStatus::kNotFinite));
    EXPECT_EQ(solver->stateHash(), before);
}

}  // namespace
}  // namespace demolish::tests
