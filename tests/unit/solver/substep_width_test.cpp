// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/substep_width.h"

#include <gtest/gtest.h>

#include <vector>

namespace demolish {
namespace {

std::vector<uint32_t> threadsUpTo(uint32_t particles) {
    std::vector<uint32_t> threads;
    forEachWidth(particles, [&](const SubstepWidth& width) { threads.push_back(width.threads); });
    return threads;
}

TEST(SubstepWidths, TheFewerParticlesTheMoreThreadsShareOne) {
    EXPECT_EQ(substepWidth(0), (SubstepWidth{16, true}));
    EXPECT_EQ(substepWidth(3'999), (SubstepWidth{16, true}));
    EXPECT_EQ(substepWidth(4'000), (SubstepWidth{8, true}));
    EXPECT_EQ(substepWidth(80'000), (SubstepWidth{4, true}));
    EXPECT_EQ(substepWidth(1'000'000), (SubstepWidth{4, false}));
}

TEST(SubstepWidths, AllThatUpToSoManyParticlesMayNeedAreVisitedOnce) {
    EXPECT_EQ(threadsUpTo(100), (std::vector<uint32_t>{16}));
    EXPECT_EQ(threadsUpTo(20'000), (std::vector<uint32_t>{16, 8, 4}));
    EXPECT_EQ(threadsUpTo(200'000), (std::vector<uint32_t>{16, 8, 4, 4}));
}

}  // namespace
}  // namespace demolish
