// SPDX-License-Identifier: Apache-2.0
// Every launch scheme of the substep's floor gives what the host gives: a scheme that skips work would make a
// floor that nothing can stand on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/bench/floor_schemes.h"
#include "tests/parity/on_the_gpu.h"

namespace demolish {
namespace {

class Floor : public tests::OnTheGpu {};

/// The largest difference of any position, rotation, velocity or spin.
double difference(const std::vector<FloorState>& a, const std::vector<FloorState>& b) {
    double most = 0;
    const auto add = [&](float x, float y) { most = std::max(most, std::abs(static_cast<double>(x) - y)); };
    const auto addVector = [&](const FloorVector& x, const FloorVector& y) {
        add(x.x, y.x);
        add(x.y, y.y);
        add(x.z, y.z);
    };
    for (size_t i = 0; i < a.size(); ++i) {
        addVector(a[i].position, b[i].position);
        addVector(vectorPart(a[i].rotation), vectorPart(b[i].rotation));
        addVector(a[i].velocity, b[i].velocity);
        addVector(a[i].spin, b[i].spin);
    }
    return most;
}

TEST_F(Floor, EverySchemeGivesTheHostsStates) {
    // Neither a multiple of a warp nor of a block. Round-off at 17 spacings is some 1e-6; what bonds do to
    // the stirring is some 1e-3.
    for (const uint32_t particles : {1000u, 4913u}) {
        const FloorProblem start = makeFloorProblem(*stoneBlock(particles));
        FloorProblem reference = start;
        stepOnHost(reference, 20);
        ASSERT_GT(difference(start.states, reference.states), 5e-4);
        const auto outcomes = cudaFloorOutcomes(start, 20);
        EXPECT_GE(outcomes.size(), 6u);
        for (const auto& outcome : outcomes)
            EXPECT_LT(difference(outcome.states, reference.states), 2e-5) << outcome.scheme;
    }
}

TEST_F(Floor, IsMeasuredWithItsScheme) {
    const auto body = stoneBlock(8000);
    const SubstepFloor floor = cudaSubstepFloor(*body);
    EXPECT_GT(floor.bonds_us, 0);
    EXPECT_GT(floor.copy_bandwidth, 1e9);
    for (const auto& scheme : floor.schemes) EXPECT_GE(scheme.microseconds, floor.bonds_us) << scheme.name;
}

}  // namespace
}  // namespace demolish
