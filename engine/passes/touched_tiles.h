// SPDX-License-Identifier: Apache-2.0
// Where something was drawn into a depth texture, in squares of 16 px, found and used on the GPU alone.
#pragma once
#include <filesystem>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"

namespace demolish::engine {

class TouchedTiles {
  public:
    /// `empty_depth`: 0 (reversed) or 1.
    TouchedTiles(const std::filesystem::path& shaders, float empty_depth);

    /// Lists the tiles of a texture with so many samples.
    void find(const gl::Texture& depth, int samples);
    /// One square each of those that find() has listed, over a target of any size, at the empty depth; the
    /// program's vertex stage is touched_tiles.vert.
    void draw(gl::Program& program) const;
    float emptyDepth() const { return empty_depth_; }

  private:
    void prepareList(int tiles);
    gl::Program find_single_, find_multi_;
    gl::VertexArray no_attributes_;
    gl::Buffer list_;
    float empty_depth_;
    int capacity_ = 0;
    int width_ = 1, height_ = 1;  ///< px, of the texture
};

}  // namespace demolish::engine
