// SPDX-License-Identifier: Apache-2.0
// The repeating noise volume that materials read (shaders/common/noise.glsl).
#pragma once
#include "engine/gl/texture.h"

namespace demolish::engine {

/// 64^3 texels, 8 lattice cells a side, mip-mapped: gradient noise with its analytic gradient. The same on
/// every machine.
gl::Texture makeNoiseVolume();

}  // namespace demolish::engine
