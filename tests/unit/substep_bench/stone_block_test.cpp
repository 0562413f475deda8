// SPDX-License-Identifier: Apache-2.0
// The block of stone: whole, bonded as it says, and a body that the solver takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/solver.h"
#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/bench/floor_problem.h"

namespace demolish {
namespace {

TEST(StoneBlock, FillsTheCubeAndBondsTwelveNeighboursInside) {
    const auto body = stoneBlock(1000);
    ASSERT_EQ(body->particles.size(), 1000u);
    double volume = 0;
    for (const auto& particle : body->particles) {
        volume += particle.volume;
        EXPECT_GT(particle.depth, 0);
    }
    EXPECT_NEAR(volume, 1, 1e-12);
    std::vector<int> bonds(1000, 0);
    for (const auto& bond : body->bonds) {
        EXPECT_LT(bond.i, bond.j);
        EXPECT_GE(bond.length, 0.8 * body->spacing);
        EXPECT_LE(bond.length, 1.7 * body->spacing) << "the diagonal of a face, and the seeds' shifts";
        ++bonds[bond.i];
        ++bonds[bond.j];
    }
    EXPECT_EQ(std::count(bonds.begin(), bonds.end(), 12), 8 * 8 * 8)
        << "those that have neighbours on all sides";
    EXPECT_EQ(*std::min_element(bonds.begin(), bonds.end()), 4) << "a corner that one diagonal reaches";
    EXPECT_EQ(body->bonds.size(), 3u * 900 + 3u * 810);
}

TEST(StoneBlock, AnyNumberBecomesTheNearestCube) {
    EXPECT_EQ(stoneBlock(8)->particles.size(), 8u);
    EXPECT_EQ(stoneBlock(2000)->particles.size(), 2197u);
    EXPECT_THROW(stoneBlock(7), UsageError);
    EXPECT_THROW(stoneBlock(5'000'000), UsageError);
}

TEST(StoneBlock, TheSolverTakesIt) {
    SceneSetup setup;
    setup.bodies.resize(1);
    setup.bodies[0].body = stoneBlock(64);
    const auto solver = makeCpuSolver(setup);
    EXPECT_EQ(solver->advanceSubsteps(10), StepStatus::kOk);
    EXPECT_EQ(solver->stats().bonds, setup.bodies[0].body->bonds.size());
}

TEST(StoneBlock, TheMemorysFloorIsTheBytesOverTheBandwidth) {
    const auto body = stoneBlock(1000);
    const SubstepFloor floor = cpuSubstepFloor(*body);
    EXPECT_EQ(floor.bytes, bytesOfSubstep(makeFloorProblem(*body)));
    EXPECT_EQ(floor.bytes, 1000 * 132.0 + 2.0 * 20 * static_cast<double>(body->bonds.size()));
    EXPECT_GT(floor.copy_bandwidth, 1e7);
    EXPECT_NEAR(floor.memory_us, 1e6 * floor.bytes / floor.copy_bandwidth, 1e-9);
    EXPECT_EQ(floor.bonds_us, 0) << "the CPU has no floor of bonds";
}

TEST(StoneBlock, WithoutAGpuItsFloorIsAnErrorInOneSentence) {
    if (findCudaDevice().usable) GTEST_SKIP() << "there is a GPU";
    try {
        cudaSubstepFloor(*stoneBlock(8));
        FAIL() << "no error";
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("--device cpu"));
    }
}

}  // namespace
}  // namespace demolish
