// SPDX-License-Identifier: Apache-2.0
#include "engine/passes/touched_tiles.h"

#include <glm/glm.hpp>

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kEmptyDepth = 0, kSamples = 1, kTile = 31;
constexpr int kTilePixels = 16;
/// As shaders/touched_tiles.comp: a DrawArraysIndirectCommand, then the tiles.
constexpr uint32_t kNoTiles[4] = {4, 0, 0, 0};

int tilesAlong(int pixels) {
    return (pixels + kTilePixels - 1) / kTilePixels;
}

}  // namespace

TouchedTiles::TouchedTiles(const std::filesystem::path& shaders, float empty_depth)
    : find_single_(shaders, {"touched_tiles.comp"}),
      find_multi_(shaders, {"touched_tiles.comp"}, "#define MULTISAMPLE\n"),
      empty_depth_(empty_depth) {}

void TouchedTiles::prepareList(int tiles) {
    if (tiles > capacity_) {
        list_ = gl::Buffer::immutable(sizeof(kNoTiles) + sizeof(uint32_t) * static_cast<size_t>(tiles),
                                      nullptr, GL_DYNAMIC_STORAGE_BIT);
        capacity_ = tiles;
    }
    list_.upload(std::as_bytes(std::span(kNoTiles)));
}

void TouchedTiles::find(const gl::Texture& depth, int samples) {
    width_ = depth.width();
    height_ = depth.height();
    const int across = tilesAlong(width_), down = tilesAlong(height_);
    prepareList(across * down);
    gl::Program& find = samples > 1 ? find_multi_ : find_single_;
    find.set(kEmptyDepth, empty_depth_);
    find.set(kSamples, samples);
    find.use();
    bindStorage(StorageBinding::kTouchedTiles, list_);
    depth.bind(0);
    glDispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>(down), 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void TouchedTiles::draw(gl::Program& program) const {
    const auto tile = static_cast<float>(kTilePixels);
    program.set(kTile, glm::vec3(tile / static_cast<float>(width_), tile / static_cast<float>(height_),
                                 empty_depth_));
    program.use();
    bindStorage(StorageBinding::kTouchedTiles, list_);
    no_attributes_.bind();
    glDisable(GL_CULL_FACE);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list_.id());
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

}  // namespace demolish::engine
