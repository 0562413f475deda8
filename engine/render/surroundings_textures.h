// SPDX-License-Identifier: Apache-2.0
// Surroundings as the light pass reads them.
#pragma once
#include <memory>

#include "engine/gl/texture.h"
#include "engine/surroundings/surroundings.h"

namespace demolish::engine {

class SurroundingsTextures {
  public:
    /// Of these from now on; nothing happens when they are those of the last call.
    void show(const std::shared_ptr<const Surroundings>& surroundings);
    /// Where shaders/common/sky.glsl looks for them.
    void bind() const;

  private:
    std::shared_ptr<const Surroundings> shown_;
    gl::Texture backdrop_, mirrored_, horizon_;
};

}  // namespace demolish::engine
