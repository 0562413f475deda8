// SPDX-License-Identifier: Apache-2.0
// Where few multiprocessors draw, clearing 4 samples of a large picture takes longer than the rest of the
// frame; looking for what to clear is computed, and computing is cheap.
#include "engine/passes/depth_eraser.h"

namespace demolish::engine {

DepthEraser::DepthEraser(const std::filesystem::path& shaders, float empty_depth)
    : touched_(shaders, empty_depth), erase_(shaders, {"touched_tiles.vert", "shadow.frag"}) {}

void DepthEraser::erase(const gl::Framebuffer& depth_only, const gl::Texture& depth) {
    depth_only.bind();
    glViewport(0, 0, depth.width(), depth.height());
    if (!known_) {
        const float empty = touched_.emptyDepth();
        glClearNamedFramebufferfv(depth_only.id(), GL_DEPTH, 0, &empty);
        return;
    }
    glDepthFunc(GL_ALWAYS);
    touched_.draw(erase_);
    glEnable(GL_CULL_FACE);
}

void DepthEraser::remember(const gl::Texture& depth, int samples) {
    touched_.find(depth, samples);
    known_ = true;
}

}  // namespace demolish::engine
