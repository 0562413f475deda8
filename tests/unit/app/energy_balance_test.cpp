// SPDX-License-Identifier: Apache-2.0
// The balance that reports show: what came in against what is found again.
#include "app/session/energy_balance.h"

#include <gtest/gtest.h>

namespace demolish {
namespace {

TEST(EnergyBalance, CountsWhatCameInAndWhatIsFoundAgain) {
    EnergyBalance balance;
    balance.start.kinetic = 10;
    balance.start.potential = 5;
    EXPECT_DOUBLE_EQ((EnergyBalance{balance.start, balance.start}.closure()), 1);
    balance.now = {.kinetic = 4,
                   .elastic = 1,
                   .potential = 3,
                   .damping = 5,
                   .friction = 6,
                   .fracture = 3,
                   .external = 7};
    EXPECT_DOUBLE_EQ(balance.broughtIn(), 10 + 7 + 2);
    EXPECT_DOUBLE_EQ(balance.closure(), 1);
    balance.now.damping += 1.9;
    EXPECT_DOUBLE_EQ(balance.closure(), 1.1);
    EXPECT_DOUBLE_EQ(EnergyBalance{}.closure(), 1);  // nothing came in
}

TEST(EnergyBalance, RoundOffOfTheWeightIsNothingThatCameIn) {
    EnergyBalance balance;  // a body of 12 kg that stands, three frames later
    balance.start.potential = 20;
    balance.now.potential = 20 - 6e-7;
    EXPECT_DOUBLE_EQ(balance.closure(), 1);
    balance.now.potential = 20 - 6e-3;  // it has sunk, and nothing says where the work went
    EXPECT_NEAR(balance.closure(), 0, 1e-9);
}

}  // namespace
}  // namespace demolish
