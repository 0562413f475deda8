// SPDX-License-Identifier: Apache-2.0
// As hand_over_test, at draft sizes: minutes.
#include <gtest/gtest.h>

#include "tests/physics/scenes/hand_over.h"

namespace demolish::tests {
namespace {

class HandOverAtDraftSize : public testing::TestWithParam<HandOverScene> {};

TEST_P(HandOverAtDraftSize, KeepsMomentumInFreeFlight) {
    expectMomentumKept(GetParam());
}
TEST_P(HandOverAtDraftSize, IsNotSeenInBooksAndFragments) {
    expectHandOverUnseen(GetParam());
}

/// A wolf that has not settled for long sways on its paws, which hand-over ends.
INSTANTIATE_TEST_SUITE_P(Scenes, HandOverAtDraftSize,
                         testing::Values(HandOverScene{"bunny", 1200, {}, 1.5},
                                         HandOverScene{"wolf", 3000, {}, 3, 4, 1.5},
                                         HandOverScene{"vase", 1000, {6, 13, 17}, 1.2},
                                         HandOverScene{"column", 1000, {15, 17, 19}, 2.6, 6}),
                         [](const auto& test) { return nameOf(test.param); });

}  // namespace
}  // namespace demolish::tests
