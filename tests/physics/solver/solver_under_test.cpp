// SPDX-License-Identifier: Apache-2.0
// One body of tests for two devices.
#include "tests/physics/solver/solver_under_test.h"

#include <cstdlib>
#include <string>

namespace demolish::tests {

bool asksForGpu() {
    const char* text = std::getenv("DEMOLISH_TEST_DEVICE");
    const std::string device = text != nullptr ? text : "cpu";
    EXPECT_TRUE(device == "cpu" || device == "cuda") << "DEMOLISH_TEST_DEVICE is \"" << device << '"';
    return device == "cuda";
}

double energySum(const EnergyLedger& e) {
    return e.kinetic + e.elastic + e.potential + e.damping + e.friction + e.fracture - e.external;
}

std::unique_ptr<Solver> makeSolver(const SceneSetup& setup) {
    return asksForGpu() ? makeCudaSolver(setup) : makeCpuSolver(setup);
}

void OnEitherDevice::SetUp() {
    if (!asksForGpu()) return;
    const CudaDevice device = findCudaDevice();
    if (!device.usable) GTEST_SKIP() << device.problem;
}

void OnTheCpu::SetUp() {
    if (asksForGpu()) GTEST_SKIP() << "double precision and single parts are tested on the CPU";
}

}  // namespace demolish::tests
