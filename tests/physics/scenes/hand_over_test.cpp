// SPDX-License-Identifier: Apache-2.0
// Hand-over and sleep are not seen in books, momentum and fragments: few particles. Draft sizes are among the
// slow tests.
#include "tests/physics/scenes/hand_over.h"

#include <gtest/gtest.h>

namespace demolish::tests {
namespace {

class HandOver : public testing::TestWithParam<HandOverScene> {};

TEST_P(HandOver, KeepsMomentumInFreeFlight) {
    expectMomentumKept(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scenes, HandOver,
                         testing::Values(HandOverScene{"bunny", 300}, HandOverScene{"wolf", 400},
                                         HandOverScene{"vase", 150, {6, 13, 17}},
                                         HandOverScene{"column", 300, {17, 19}}),
                         [](const auto& test) { return nameOf(test.param); });

/// Of the others only at more particles: a wolf of a few hundred does not stand, a vase has no wall, and a
/// column is a handful of pieces.
TEST(HandOverOfTheRabbit, IsNotSeenInBooksAndFragments) {
    expectHandOverUnseen({"bunny", 300, {}, 0.8});
}

}  // namespace
}  // namespace demolish::tests
