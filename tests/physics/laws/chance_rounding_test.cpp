// SPDX-License-Identifier: Apache-2.0
// Changes below the last digit of what they are added to add up.
#include "sim_cuda/physics/chance_rounding.h"

#include <gtest/gtest.h>

#include <limits>

namespace demolish {
namespace {

TEST(ChanceRounding, KnowsTheLastDigit) {
    for (const float x : {1.0f, 1.5f, 100.0f, -3e-7f}) {
        const float above = std::nextafter(std::abs(x), std::numeric_limits<float>::infinity());
        EXPECT_EQ(lastDigit(x), above - std::abs(x)) << x;
    }
    EXPECT_EQ(lastDigit(1.0), std::numeric_limits<double>::epsilon());
    EXPECT_EQ(lastDigit(0.0f), 0.0f);
}

TEST(ChanceRounding, AddsUpWhatTheNearestNumberLoses) {
    constexpr int kTimes = 100000;
    for (const double digits : {-0.3, 0.1, 0.49, 0.51, 1.3, 7.7}) {
        const float start = 100, change = static_cast<float>(digits) * lastDigit(start);
        float sum = start;
        for (int k = 0; k < kTimes; ++k)
            sum = addedByChance(sum, change, static_cast<float>(uniformOf(1, k)));
        const double added = (static_cast<double>(sum) - start) / lastDigit(start);
        EXPECT_NEAR(added, digits * kTimes, 1e3) << digits;  // some six times the root of kTimes / 4
    }
}

TEST(ChanceRounding, LeavesAloneWhatDoesNotChange) {
    for (int k = 0; k < 1000; ++k)
        EXPECT_EQ(addedByChance(1.0f, 0.0f, static_cast<float>(uniformOf(2, k))), 1.0f);
}

}  // namespace
}  // namespace demolish
