// SPDX-License-Identifier: Apache-2.0
// For tests that need a GPU: skipped, with the reason, where there is none.
#pragma once
#include <gtest/gtest.h>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

class OnTheGpu : public ::testing::Test {
  protected:
    void SetUp() override {
        const CudaDevice device = findCudaDevice();
        if (!device.usable) GTEST_SKIP() << device.problem;
    }
};

}  // namespace demolish::tests
