// SPDX-License-Identifier: Apache-2.0
// How a camera takes a frame: its lens, how long its shutter is open, and of how many pictures that is
// averaged.
#pragma once
#include <cstdint>

#include "engine/scene/frame_view.h"

namespace demolish::engine {

struct Lens {
    float aperture =
        0;  ///< F number of a lens before a full-frame sensor (24 mm high); 0: a pinhole, sharp everywhere
    float focus = 0;       ///< m along the view axis; 0: where the camera's target is
    float shutter = 0;     ///< share of a frame's time that the shutter is open, up to the frame's moment
    uint32_t samples = 0;  ///< pictures that a frame is averaged of; 0: as many as the above asks for

    bool operator==(const Lens&) const = default;
};

/// Of how many pictures a frame is averaged: 1 where nothing asks for more.
uint32_t picturesOf(const Lens& lens);
/// m: half the width of the opening that light comes through; 0 for a pinhole.
float apertureRadius(const Lens& lens, const Camera& camera);
/// The view of the i-th of n pictures of linear light: through another point of the lens, moved by another
/// part of a pixel.
FrameView pictureView(const FrameView& frame, const Lens& lens, uint32_t i, uint32_t n);
/// When it is taken: 0 a frame before, 1 at the frame's moment.
float pictureMoment(const Lens& lens, uint32_t i, uint32_t n);
/// When light falls on it, where a frame is so many seconds long: the pictures of a frame follow each other
/// without a gap. A still's own where the shutter is not open.
Opening pictureOpening(const Lens& lens, float frame_s, uint32_t i, uint32_t n);

}  // namespace demolish::engine
