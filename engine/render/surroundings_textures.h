// SPDX-License-Identifier: Apache-2.0
// Surroundings as the light pass reads them.
#pragma once
#include <memory>

#include "engine/gl/texture.h"
#include "engine/surroundings/surroundings.h"

namespace demolish::engine {

class SurroundingsTextures {
  public:
    /// Of these from now on; `over_floor`: one is drawn that ends in the haze of the horizon. Nothing happens
    /// when both are those of the last call.
    void show(const std::shared_ptr<const Surroundings>& surroundings, bool over_floor);
    /// Where shaders/common/sky.glsl looks for them.
    void bind() const;

  private:
    std::shared_ptr<const Surroundings> shown_;
    bool over_floor_ = false;
    gl::Texture backdrop_, mirrored_, horizon_;
};

}  // namespace demolish::engine
