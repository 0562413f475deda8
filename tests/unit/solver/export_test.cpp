// SPDX-License-Identifier: Apache-2.0
// What the solver writes for drawing: particles, fragments, transforms.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {
namespace {

struct Frame {
    std::vector<ParticleInstance> particles;
    std::vector<uint32_t> fragment;
    std::vector<FragmentTransform> transforms;

    Frame(Solver& solver, size_t count, ParticleColour colour = ParticleColour::kFragment)
        : particles(count), fragment(count), transforms(count) {
        RenderStreams streams;
        streams.particles = {particles.data(), count};
        streams.particle_fragment = {fragment.data(), count};
        streams.transforms = {transforms.data(), count};
        streams.colour = colour;
        solver.exportFrame(streams, true);
    }
};

TEST(SolverExport, AWholeBodyIsDrawnWhereItWasPlaced) {
    SceneSetup setup = freeBody(latticeBody(3, 3, 3, 0.1));
    setup.bodies[0].position = {1, 2, 3};
    setup.bodies[0].rotation = {0.5, 0.5, 0.5, 0.5};
    auto solver = makeCpuSolver(setup);
    const Frame frame(*solver, 27);
    EXPECT_EQ(solver->stats().fragments, 1u);
    EXPECT_NEAR(solver->stats().largest_fragment_fraction, 1, 1e-6);
    for (const uint32_t slot : frame.fragment) EXPECT_EQ(slot, 0u);
    EXPECT_NEAR(frame.transforms[0].translation.x, 1, 1e-5);
    EXPECT_NEAR(frame.transforms[0].translation.z, 3, 1e-5);
    EXPECT_NEAR(std::abs(frame.transforms[0].rotation.w), 0.5, 1e-5);
    EXPECT_EQ(frame.transforms[0].age, 0u);
}

TEST(SolverExport, FragmentsAreCountedAndDrawnByTheirLowestParticle) {
    const size_t count = 640 + kMaxProjectiles;
    auto solver = makeCpuSolver(breakingScene());
    for (int k = 0; k < 4; ++k) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const Frame frame(*solver, count, ParticleColour::kDamage);
    std::map<uint32_t, uint32_t> sizes;
    for (uint32_t i = 0; i < 640; ++i) {
        EXPECT_LE(frame.fragment[i], i);
        EXPECT_EQ(frame.particles[i].fragment, frame.fragment[i]);
        EXPECT_GE(frame.particles[i].value, 0.0f);
        EXPECT_LE(frame.particles[i].value, 1.0f);
        ++sizes[frame.fragment[i]];
    }
    EXPECT_EQ(sizes.size(), solver->stats().fragments);
    EXPECT_GT(sizes.size(), 3u);
    for (const auto& [slot, size] : sizes) EXPECT_GT(frame.transforms[slot].age, 0u) << size;
    uint32_t largest = 0;
    for (const auto& [slot, size] : sizes) largest = std::max(largest, size);
    EXPECT_NEAR(solver->stats().largest_fragment_fraction, largest / 640.0, 1e-5);
}

TEST(SolverExport, ColoursSayWhatWasAskedFor) {
    SceneSetup setup = freeBody(latticeBody(3, 3, 3, 0.1));
    setup.bodies[0].velocity = {0.5, 0, 0};
    auto solver = makeCpuSolver(setup);
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const Frame speed(*solver, 27, ParticleColour::kSpeed), damage(*solver, 27, ParticleColour::kDamage);
    const Frame stress(*solver, 27, ParticleColour::kStress);
    for (uint32_t i = 0; i < 27; ++i) {
        EXPECT_NEAR(speed.particles[i].value, 0.25f, 1e-4f);  // of twice the critical velocity
        EXPECT_EQ(damage.particles[i].value, 0.0f);
        EXPECT_LT(stress.particles[i].value, 0.01f);
    }
}

TEST(SolverExport, ProjectilesAloneAreThoseBehindTheParticles) {
    SceneSetup setup = freeBody(latticeBody(3, 3, 3, 0.1));
    for (const double x : {3.0, -4.0}) {
        Projectile ball;
        ball.position = {x, 1, 2};
        ball.velocity = {1, 0, 0};
        ball.radius = 0.1 * std::abs(x);
        setup.projectiles.push_back(ball);
    }
    auto solver = makeCpuSolver(setup);
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const Frame frame(*solver, 29);
    std::vector<ParticleInstance> alone(2);
    RenderStreams streams;
    streams.projectiles = {alone.data(), alone.size()};
    solver->exportFrame(streams);
    for (size_t p = 0; p < 2; ++p) {
        const ParticleInstance& among = frame.particles[27 + p];
        EXPECT_EQ(alone[p].position.x, among.position.x);
        EXPECT_EQ(alone[p].radius, among.radius);
        EXPECT_EQ(alone[p].fragment, among.fragment);
        EXPECT_NEAR(alone[p].radius, 0.1 * std::abs(setup.projectiles[p].position.x), 1e-6);
    }
}

TEST(SolverExport, AnExportWithoutDrawListsLeavesThemToTheNext) {
    SceneSetup setup = freeBody(latticeBody(3, 3, 3, 0.1));
    auto solver = makeCpuSolver(setup);
    std::vector<uint32_t> fragment(27);
    RenderStreams slots;
    slots.particle_fragment = {fragment.data(), fragment.size()};
    solver->exportFrame(slots);
    DrawCommands commands{};
    RenderStreams lists;
    lists.commands = {&commands, 1};
    solver->exportFrame(lists);
    EXPECT_EQ(commands.cracks.count, 6u);
}

TEST(SolverExport, FreshStreamsOfAnotherReaderLeaveTheDrawListsToTheNext) {
    auto solver = makeCpuSolver(breakingScene());
    const auto exported = [&](bool fresh) {
        DrawCommands commands{};
        RenderStreams lists;
        lists.commands = {&commands, 1};
        solver->exportFrame(lists, fresh);
        return commands.cracks.count;
    };
    EXPECT_EQ(exported(false), 6u);
    EXPECT_EQ(exported(false), 0u) << "nothing has broken since";
    for (int k = 0; k < 3; ++k) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    ASSERT_GT(solver->stats().bonds_broken, 0u);
    EXPECT_EQ(exported(true), 6u);
    EXPECT_EQ(exported(false), 6u) << "these streams have not seen the break";
    EXPECT_EQ(exported(false), 0u);
}

}  // namespace
}  // namespace demolish::tests
