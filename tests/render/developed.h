// SPDX-License-Identifier: Apache-2.0
// What a film shows.
#pragma once
#include <utility>

#include "engine/render/film.h"
#include "engine/render/frame_capture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {

/// The picture, of the view's size, that all pictures added to the film make under the view's light.
inline Image developed(Film& film, const FrameView& view) {
    Image result;
    FrameCapture capture(view.width, view.height, [&](uint64_t, Image image) { result = std::move(image); });
    film.develop(view.lighting, capture.framebuffer());
    capture.submit(0);
    capture.finish();
    return result;
}

}  // namespace demolish::engine::test
