// SPDX-License-Identifier: Apache-2.0
// The part of the window that shows the body: drawn into a buffer of its own size, then copied into the
// window.
#pragma once
#include <filesystem>
#include <memory>

#include "app/panel/layout.h"
#include "engine/render/frame_capture.h"

namespace demolish {

class PictureTarget {
  public:
    /// Framebuffer of this size; made anew when the size changes.
    unsigned framebuffer(int width, int height);
    /// Clears the window and copies the picture to its place.
    void copyToWindow(const PictureArea& area, int window_height) const;

  private:
    std::unique_ptr<engine::FrameCapture> target_;
    int width_ = 0, height_ = 0;
};

/// Everything in the window's back buffer, as PNG. Throws engine::ImageError.
void saveWindow(const std::filesystem::path& file, int width, int height);

}  // namespace demolish
