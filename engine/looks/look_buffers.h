// SPDX-License-Identifier: Apache-2.0
// Looks of models on the GPU: materials and triangles in one buffer, pictures in texture arrays
// (shaders/common/model_looks.glsl).
#pragma once
#include <array>

#include "engine/gl/buffer.h"
#include "engine/gl/texture.h"
#include "engine/looks/body_looks.h"
#include "engine/looks/picture_layout.h"

namespace demolish::engine {

class LookBuffers {
  public:
    /// The GL context is current. The pictures may go out of scope afterwards.
    explicit LookBuffers(const BodyLooks& looks);
    /// Storage binding 15, texture units 16 to 19.
    void bind() const;
    /// Something is cut out of the body by its picture.
    bool isMasked() const { return is_masked_; }
    /// What is cut out shows the back of what lies behind.
    bool isDoubleSided() const { return is_double_sided_; }
    /// Something shines, or is shaded by a picture of occlusion.
    bool glows() const { return glows_; }

  private:
    gl::Buffer words_;
    std::array<gl::Texture, kPictureArrays> arrays_;
    bool is_masked_ = false, is_double_sided_ = false, glows_ = false;
};

}  // namespace demolish::engine
