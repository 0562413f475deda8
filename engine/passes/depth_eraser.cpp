// SPDX-License-Identifier: Apache-2.0
// Where few multiprocessors draw, clearing 4 samples of a large picture takes longer than the rest of the
// frame; looking for what to clear is computed, and computing is cheap.
#include "engine/passes/depth_eraser.h"

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kEmptyDepth = 0, kSamples = 1, kTileEmpty = 0;
constexpr int kTilePixels = 16;
/// As shaders/touched_tiles.comp: a DrawArraysIndirectCommand, then the tiles.
constexpr uint32_t kNoTiles[4] = {4, 0, 0, 0};

int tilesAlong(int pixels) {
    return (pixels + kTilePixels - 1) / kTilePixels;
}

}  // namespace

DepthEraser::DepthEraser(const std::filesystem::path& shaders, float empty_depth)
    : find_single_(shaders, {"touched_tiles.comp"}),
      find_multi_(shaders, {"touched_tiles.comp"}, "#define MULTISAMPLE\n"),
      erase_(shaders, {"tile_erase.vert", "shadow.frag"}),
      empty_depth_(empty_depth) {}

void DepthEraser::prepareList(int tiles) {
    if (tiles > capacity_) {
        list_ = gl::Buffer::immutable(sizeof(kNoTiles) + sizeof(uint32_t) * static_cast<size_t>(tiles),
                                      nullptr, GL_DYNAMIC_STORAGE_BIT);
        capacity_ = tiles;
    }
    list_.upload(std::as_bytes(std::span(kNoTiles)));
}

void DepthEraser::erase(const gl::Framebuffer& depth_only, const gl::Texture& depth) {
    depth_only.bind();
    glViewport(0, 0, depth.width(), depth.height());
    if (!known_) {
        glClearNamedFramebufferfv(depth_only.id(), GL_DEPTH, 0, &empty_depth_);
        return;
    }
    const auto tile = static_cast<float>(kTilePixels);
    erase_.set(kTileEmpty, glm::vec4(tile / static_cast<float>(depth.width()),
                                     tile / static_cast<float>(depth.height()), empty_depth_, 0));
    erase_.use();
    bindStorage(StorageBinding::kTouchedTiles, list_);
    no_attributes_.bind();
    glDepthFunc(GL_ALWAYS);
    glDisable(GL_CULL_FACE);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list_.id());
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glEnable(GL_CULL_FACE);
}

void DepthEraser::remember(const gl::Texture& depth, int samples) {
    const int across = tilesAlong(depth.width()), down = tilesAlong(depth.height());
    prepareList(across * down);
    gl::Program& find = samples > 1 ? find_multi_ : find_single_;
    find.set(kEmptyDepth, empty_depth_);
    find.set(kSamples, samples);
    find.use();
    bindStorage(StorageBinding::kTouchedTiles, list_);
    depth.bind(0);
    glDispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>(down), 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    known_ = true;
}

}  // namespace demolish::engine
