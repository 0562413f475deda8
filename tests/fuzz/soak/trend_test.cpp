// SPDX-License-Identifier: Apache-2.0
// The soak's judgement: noise is no growth, a leak is, and few rounds say nothing.
#include "tests/fuzz/soak/trend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fuzz/support/dice.h"

namespace demolish::fuzz {
namespace {

using testing::HasSubstr;

/// Warms up for 10 rounds, then stays within 5 MiB, but for what leaks in each round.
std::vector<Usage> rounds(size_t count, double leaked_mib, double leaked_files) {
    Dice dice(1, count);
    std::vector<Usage> samples;
    for (size_t k = 0; k < count; ++k) {
        const auto number = static_cast<double>(k);
        samples.push_back({100 + 20 * std::min(number, 10.0) + dice.uniform(-5, 5) + leaked_mib * number, 0,
                           30 + leaked_files * number});
    }
    samples[count - 2].resident += 200;  // one large body
    return samples;
}

TEST(Growth, NoiseAndASingleHighSampleAreNone) {
    EXPECT_THAT(growth(rounds(30, 0, 0)), testing::IsEmpty());
}

TEST(Growth, ALeakIsFound) {
    EXPECT_THAT(growth(rounds(30, 2, 0)), testing::ElementsAre(HasSubstr("resident memory")));
    EXPECT_THAT(growth(rounds(30, 0, 0.2)), testing::ElementsAre(HasSubstr("open files")));
}

TEST(Growth, FewRoundsSayNothing) {
    EXPECT_THAT(growth(rounds(5, 0, 0)), testing::ElementsAre(HasSubstr("too few")));
}

TEST(Growth, TheTrendIsThatOfAStraightLine) {
    EXPECT_DOUBLE_EQ(trend({1, 2, 3, 4}), 3);
    EXPECT_DOUBLE_EQ(trend({5, 5, 900, 5, 5}), 0);
    EXPECT_DOUBLE_EQ(trend({}), 0);
}

}  // namespace
}  // namespace demolish::fuzz
