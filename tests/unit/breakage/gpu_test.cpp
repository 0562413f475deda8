// SPDX-License-Identifier: Apache-2.0
// The same item on the GPU: the same bytes.
#include <gtest/gtest.h>

#include "app/breakage/item_file.h"
#include "sim_cuda/api/solver.h"

namespace demolish::test {
namespace {

TEST(BreakageOnTheGpu, GivesTheBytesOfTheCpu) {
    const CudaDevice device = findCudaDevice();
    if (!device.usable) GTEST_SKIP() << device.problem;
    BreakagePlan plan;
    BreakageExperiment experiment = findExperiment("breakage");
    experiment.grains = 80;
    experiment.packings = 2;
    experiment.velocities = 3;
    experiment.slowest = 20;
    experiment.fastest = 80;
    plan.experiments = {experiment};
    const auto runs = plan.items()[0];
    const ItemResult cpu = runItem(plan, runs, false), gpu = runItem(plan, runs, true);
    EXPECT_GT(cpu.bonds_broken, 20u);
    EXPECT_EQ(itemJson(plan, 0, runs, gpu), itemJson(plan, 0, runs, cpu));
}

}  // namespace
}  // namespace demolish::test
