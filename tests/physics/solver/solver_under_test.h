// SPDX-License-Identifier: Apache-2.0
// Which solver the tests of this folder ask: the CPU's, or the GPU's when the same program is run a second
// time with DEMOLISH_TEST_DEVICE=cuda (CTest label gpu).
#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

/// True when the environment asks for the GPU. Anything but "cpu" and "cuda" fails the calling test.
bool asksForGpu();

/// J: what there is and where it went, less what came from outside; the same at all times.
double energySum(const EnergyLedger& ledger);

/// A solver of single precision on the device under test.
std::unique_ptr<Solver> makeSolver(const SceneSetup& setup);

/// Tests that hold on either device; skipped when the GPU is asked for and there is none.
class OnEitherDevice : public testing::Test {
  protected:
    void SetUp() override;
};

/// Tests of what only the CPU has: double precision, and the solver's parts one by one.
class OnTheCpu : public testing::Test {
  protected:
    void SetUp() override;
};

}  // namespace demolish::tests
