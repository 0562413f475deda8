// SPDX-License-Identifier: Apache-2.0
// Renderer on a context without a window, with the frame that it draws into.
#pragma once
#include <memory>
#include <span>

#include "engine/platform/headless_context.h"
#include "engine/render/frame_capture.h"
#include "engine/render/renderer.h"

namespace demolish {

class HeadlessStage {
  public:
    /// On the GPU that computes when `on_gpu`. Throws gl::GlError.
    explicit HeadlessStage(bool on_gpu);

    const engine::ContextInfo& info() const { return context_.info(); }
    engine::Renderer& renderer() { return renderer_; }

  private:
    engine::HeadlessContext context_;
    engine::Renderer renderer_;
};

}  // namespace demolish
