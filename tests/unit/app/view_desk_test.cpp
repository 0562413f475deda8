// SPDX-License-Identifier: Apache-2.0
// What the window says besides the running shot, when that is another one.
#include <gtest/gtest.h>

#include "app/commands/view_desk.h"
#include "app/session/scene_file.h"

namespace demolish {
namespace {

TEST(ViewDesk, StartsItsFrameTimesAnewWithANewBody) {
    Shot shot = loadScene("block");
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = 60;
    const Session session(buildShot(shot, {}, {}), {.draw = false});
    ViewDesk desk(session, shot);
    desk.history.add(FrameSample{});
    desk.adoptBody(session, false);
    EXPECT_TRUE(desk.history.samples().empty());
}

}  // namespace
}  // namespace demolish
