// SPDX-License-Identifier: Apache-2.0
// Pebbles and crystals in a repeating volume (shaders/common/solid_texture.glsl).
#pragma once
#include "engine/gl/texture.h"

namespace demolish::engine {

/// 64^3 texels, 8 lattice cells along a side, mip-mapped. r: lattice cells to the edge of the nearest pebble,
/// 0.5 on it and less inside; g: that pebble's tone, 0..1; b: lattice cells to the border of a crystal,
/// twice; a: that crystal's tone.
gl::Texture makeCellVolume();

}  // namespace demolish::engine
