// SPDX-License-Identifier: Apache-2.0
// Captured frames arrive complete, in order, and the right way up.
#include <glad/gl.h>

#include "engine/render/frame_capture.h"
#include "tests/render/gl_fixture.h"

namespace demolish::engine::test {
namespace {

using CaptureTest = GlTest;

TEST_F(CaptureTest, FramesArriveInOrderWithTheirContent) {
    std::vector<uint64_t> order;
    FrameCapture capture(
        33, 17,
        [&](uint64_t frame, Image image) {
            order.push_back(frame);
            ASSERT_EQ(image.width, 33);
            ASSERT_EQ(image.height, 17);
            EXPECT_EQ(image.at(32, 16)[0], static_cast<uint8_t>(frame * 20)) << "frame " << frame;
        },
        2);
    for (uint64_t frame = 0; frame < 7; ++frame) {
        const float colour[4] = {static_cast<float>(frame * 20) / 255.0f, 0, 0, 1};
        glClearNamedFramebufferfv(capture.framebuffer(), GL_COLOR, 0, colour);
        capture.submit(frame);
    }
    capture.finish();
    EXPECT_EQ(order, (std::vector<uint64_t>{0, 1, 2, 3, 4, 5, 6}));
}

TEST_F(CaptureTest, FirstRowIsTheTop) {
    Image picture;
    FrameCapture capture(8, 6, [&](uint64_t, Image image) { picture = std::move(image); });
    const float black[4] = {0, 0, 0, 1}, white[4] = {1, 1, 1, 1};
    glClearNamedFramebufferfv(capture.framebuffer(), GL_COLOR, 0, black);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 4, 8, 2);  // GL counts rows from the bottom
    glClearNamedFramebufferfv(capture.framebuffer(), GL_COLOR, 0, white);
    glDisable(GL_SCISSOR_TEST);
    capture.submit(0);
    capture.finish();
    EXPECT_EQ(picture.at(3, 0)[1], 255);
    EXPECT_EQ(picture.at(3, 1)[1], 255);
    EXPECT_EQ(picture.at(3, 2)[1], 0);
    EXPECT_EQ(picture.at(3, 5)[1], 0);
}

}  // namespace
}  // namespace demolish::engine::test
