// SPDX-License-Identifier: Apache-2.0
// Takes finished frames off the GPU without waiting for it: rotating pixel-pack buffers with fences.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>

#include "engine/image/image.h"

namespace demolish::engine {

/// Draw into framebuffer(), call submit() once a frame, finish() at the end; frames arrive in order, some
/// submits later.
class FrameCapture {
  public:
    using Sink = std::function<void(uint64_t frame, Image image)>;

    /// `buffer_count` frames may be in flight (2 or 3). Throws gl::GlError.
    FrameCapture(int width, int height, Sink sink, int buffer_count = 3);
    ~FrameCapture();

    /// Single-sample RGBA8 target, for Renderer::draw and whatever is drawn over it.
    unsigned framebuffer() const;
    /// Starts the read-back of what was drawn. Hands finished frames to the sink; waits only when all buffers
    /// are busy.
    void submit(uint64_t frame);
    /// Waits for every frame in flight and hands it over.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace demolish::engine
