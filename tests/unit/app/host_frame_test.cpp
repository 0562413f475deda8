// SPDX-License-Identifier: Apache-2.0
// A frame read to the host is what the solver exports, from either device: on the GPU when the same program
// is run with DEMOLISH_TEST_DEVICE=cuda (CTest label gpu).
#include "app/bridge/host_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <vector>

#include "app/session/ball_flight.h"
#include "app/session/built_shot.h"
#include "app/session/scene_file.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Transforms of slots in use.
std::vector<FragmentTransform> transformsInUse(const HostFrame& frame) {
    std::vector<FragmentTransform> used;
    for (uint32_t i = 0; i < frame.particle_fragment.size(); ++i)
        if (frame.particle_fragment[i] == i) used.push_back(frame.transforms[i]);
    return used;
}

void expectSame(const HostFrame& a, const HostFrame& b) {
    EXPECT_TRUE(sameBytes(a.particles, b.particles));
    EXPECT_TRUE(sameBytes(a.projectiles, b.projectiles));
    EXPECT_TRUE(sameBytes(a.particle_fragment, b.particle_fragment));
    EXPECT_TRUE(sameBytes(transformsInUse(a), transformsInUse(b)));
    EXPECT_TRUE(sameBytes(a.interior_vertices, b.interior_vertices));
    EXPECT_TRUE(sameBytes(a.interior_indices, b.interior_indices));
    EXPECT_TRUE(sameBytes(a.exterior_indices, b.exterior_indices));
    EXPECT_TRUE(sameBytes(a.crack_edges, b.crack_edges));
    EXPECT_EQ(std::memcmp(&a.commands, &b.commands, sizeof(DrawCommands)), 0);
    EXPECT_TRUE(sameBytes(a.damage, b.damage));
    EXPECT_TRUE(sameBytes(a.stress, b.stress));
    EXPECT_TRUE(sameBytes(a.speed, b.speed));
}

class HostFrameTest : public OnEitherDevice {
  protected:
    /// A block that a ball has broken: these few cells break from 65 m/s.
    static BuiltShot brokenBlock(DeviceChoice device) {
        Shot shot = loadScene("block");
        shot.device = device;
        shot.fineness.particles = 150;
        shot.impact.arrival_time = 0.03;
        shot.impact.velocity = 130;
        BuiltShot built = buildShot(shot, {}, {});
        const TimedBall ball = ballsOf(built.shot).front();
        built.solver->fire(makeBall(built.shot, built.setup, ball, ball.flight_time).ball);
        for (int frame = 0; frame < 6; ++frame) EXPECT_EQ(built.solver->advanceFrame(), StepStatus::kOk);
        EXPECT_GT(built.solver->stats().fragments, 1u);
        return built;
    }
    static BuiltShot brokenBlock() {
        return brokenBlock(asksForGpu() ? DeviceChoice::kCuda : DeviceChoice::kCpu);
    }
};

/// The CPU writes into plain memory, so that what it exports can be had without readFrame().
HostFrame exportedByTheCpu(Solver& solver, ParticleColour colour) {
    const StreamSizes sizes = solver.exportSizes();
    const size_t particles = solver.stats().particles;
    HostFrame frame;
    const auto stream = [](auto& values, size_t count) {
        values.resize(count);
        return Stream<typename std::remove_reference_t<decltype(values)>::value_type>{values.data(), count};
    };
    RenderStreams streams;
    streams.particles = stream(frame.particles, particles);
    streams.projectiles = stream(frame.projectiles, kMaxProjectiles);
    streams.particle_fragment = stream(frame.particle_fragment, particles);
    streams.transforms = stream(frame.transforms, particles);
    streams.interior_vertices = stream(frame.interior_vertices, sizes.interior_vertices);
    streams.interior_indices = stream(frame.interior_indices, sizes.interior_indices);
    streams.exterior_indices = stream(frame.exterior_indices, sizes.exterior_indices);
    streams.crack_edges = stream(frame.crack_edges, sizes.crack_edges);
    streams.commands = {&frame.commands, 1};
    streams.colours = {stream(frame.damage, particles), stream(frame.stress, particles),
                       stream(frame.speed, particles)};
    streams.colour = colour;
    solver.exportFrame(streams, true);
    return frame;
}

/// The first elements are the same, and all that draw calls use are there.
template <class T>
void expectUsedPart(const std::vector<T>& read, const std::vector<T>& exported, size_t used) {
    ASSERT_EQ(read.size(), used);
    EXPECT_GT(used, 0u);
    EXPECT_EQ(std::memcmp(read.data(), exported.data(), used * sizeof(T)), 0);
}

TEST_F(HostFrameTest, HoldsWhatASolverOnTheCpuExports) {
    if (asksForGpu()) GTEST_SKIP() << "the GPU cannot write into plain memory";
    const BuiltShot built = brokenBlock();
    const HostFrame read = readFrame(*built.solver, FrameParts::kAll, ParticleColour::kSpeed);
    HostFrame exported = exportedByTheCpu(*built.solver, ParticleColour::kSpeed);
    EXPECT_EQ(read.stats.frame, 6u);
    expectUsedPart(read.interior_indices, exported.interior_indices, read.commands.interior.count);
    expectUsedPart(read.exterior_indices, exported.exterior_indices, read.commands.exterior.count);
    expectUsedPart(read.crack_edges, exported.crack_edges, read.commands.cracks.instance_count);
    ASSERT_FALSE(read.interior_indices.empty());
    const uint32_t highest = *std::max_element(read.interior_indices.begin(), read.interior_indices.end());
    expectUsedPart(read.interior_vertices, exported.interior_vertices, highest + size_t{1});
    exported.interior_indices.resize(read.interior_indices.size());
    exported.exterior_indices.resize(read.exterior_indices.size());
    exported.crack_edges.resize(read.crack_edges.size());
    exported.interior_vertices.resize(read.interior_vertices.size());
    expectSame(read, exported);
    EXPECT_GT(*std::max_element(read.damage.begin(), read.damage.end()), 0);
    EXPECT_GT(read.projectiles[0].radius, 0);
}

TEST_F(HostFrameTest, IsTheSameFromTheGpuAndFromTheCpu) {
    if (!asksForGpu()) GTEST_SKIP() << "without a GPU there is nothing to compare";
    const BuiltShot on_gpu = brokenBlock(), on_cpu = brokenBlock(DeviceChoice::kCpu);
    expectSame(readFrame(*on_gpu.solver), readFrame(*on_cpu.solver));
}

TEST_F(HostFrameTest, WhatWasNotAskedForIsEmpty) {
    const BuiltShot built = brokenBlock();
    const HostFrame slots = readFrame(*built.solver, FrameParts::kFragments);
    EXPECT_EQ(slots.particle_fragment.size(), built.solver->stats().particles);
    EXPECT_TRUE(slots.particles.empty() && slots.projectiles.empty() && slots.transforms.empty());
    EXPECT_TRUE(slots.interior_vertices.empty() && slots.exterior_indices.empty() && slots.damage.empty());
    const HostFrame two = readFrame(*built.solver, FrameParts::kTransforms | FrameParts::kColours);
    EXPECT_EQ(two.transforms.size(), built.solver->stats().particles);
    EXPECT_EQ(two.speed.size(), built.solver->stats().particles);
    EXPECT_TRUE(two.particle_fragment.empty() && two.crack_edges.empty());
}

}  // namespace
}  // namespace demolish::tests
