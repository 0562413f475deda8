// SPDX-License-Identifier: Apache-2.0
// Copies between framebuffers; the only raw GL of the window program.
#include "app/commands/picture_target.h"

#include <glad/gl.h>

#include <algorithm>

#include "engine/image/png.h"

namespace demolish {

unsigned PictureTarget::framebuffer(int width, int height) {
    if (!target_ || width != width_ || height != height_) {
        target_.reset();
        target_ = std::make_unique<engine::FrameCapture>(
            width, height, [](uint64_t, engine::Image) {}, 2);
        width_ = width;
        height_ = height;
    }
    return target_->framebuffer();
}

void PictureTarget::copyToWindow(const PictureArea& area, int window_height) const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.115f, 0.12f, 0.135f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const int bottom = window_height - area.y - area.height;  // GL counts from below
    glBlitNamedFramebuffer(target_->framebuffer(), 0, 0, 0, width_, height_, area.x, bottom,
                           area.x + area.width, bottom + area.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void saveWindow(const std::filesystem::path& file, int width, int height) {
    engine::Image upside_down(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.pixels.data());
    engine::Image image(width, height);
    const size_t row = static_cast<size_t>(width) * 4;
    for (int y = 0; y < height; ++y) std::copy_n(upside_down.at(0, height - 1 - y), row, image.at(0, y));
    engine::writePng(file, image);
}

}  // namespace demolish
