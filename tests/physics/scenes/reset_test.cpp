// SPDX-License-Identifier: Apache-2.0
// A shot that is put back to its start goes on as a new one does, to the last bit.
#include <gtest/gtest.h>

#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

void advance(Session& session, int frames) {
    for (int frame = 0; frame < frames; ++frame) ASSERT_EQ(session.advance(), StepStatus::kOk);
}

/// The ball of the wall is led from the first frame on, long before it hits: what it was led by in that frame
/// is seen in the contact lists with which it meets the bricks.
TEST(Reset, OfAWallThatIsHitLaterChangesNoBit) {
    constexpr int kFrames = 55;
    const Shot shot = smallScene("wall", 12);
    Session fresh(buildShot(shot, {}, {}), {.draw = false}), used(buildShot(shot, {}, {}), {.draw = false});
    advance(used, 1);
    used.apply(command::Reset{}, 0);
    advance(fresh, kFrames);
    advance(used, kFrames);
    EXPECT_GT(fresh.solver().stats().bonds_broken, 0u);
    EXPECT_EQ(used.solver().stateHash(), fresh.solver().stateHash());
}

}  // namespace
}  // namespace demolish::tests
