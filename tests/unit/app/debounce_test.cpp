// SPDX-License-Identifier: Apache-2.0
// A value is released once, after it has rested.
#include "app/session/debounce.h"

#include <gtest/gtest.h>

namespace demolish {
namespace {

TEST(Debounce, ReleasesTheLastValueOnceAfterTheRest) {
    Debounce<int> debounce(0.25);
    EXPECT_FALSE(debounce.take(0).has_value());
    debounce.push(1, 10.0);
    EXPECT_FALSE(debounce.take(10.2).has_value());
    debounce.push(2, 10.2);  // the slider moves on: the rest starts anew
    EXPECT_FALSE(debounce.take(10.4).has_value());
    EXPECT_TRUE(debounce.waiting());
    EXPECT_EQ(debounce.take(10.45), 2);
    EXPECT_FALSE(debounce.take(11).has_value());
    EXPECT_FALSE(debounce.waiting());
}

TEST(Debounce, ForgetsWhenCleared) {
    Debounce<int> debounce(0.25);
    debounce.push(1, 0);
    debounce.clear();
    EXPECT_FALSE(debounce.take(1).has_value());
}

}  // namespace
}  // namespace demolish
