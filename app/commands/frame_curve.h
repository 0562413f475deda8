// SPDX-License-Identifier: Apache-2.0
// The frame time over a shot as a picture: stages stacked, phases marked.
#pragma once
#include <span>
#include <string>

#include "app/session/frame_times.h"

namespace demolish {

/// An SVG file. Above: ms of each frame over simulated time, stacked by stage, with the median FPS of each
/// phase (and the paper's) on top and a tick for each frame in which bonds broke. Below: the particles that
/// cost anything. `title` and `subtitle` say what ran where.
std::string frameCurveSvg(std::span<const FrameSample> samples, std::span<const Phase> phases,
                          const std::string& title, const std::string& subtitle);

/// Distance of an axis' ticks: 1, 2 or 5 times a power of ten, so that at most `most_ticks` fit in `length`.
double tickStep(double length, int most_ticks);

}  // namespace demolish
