// SPDX-License-Identifier: Apache-2.0
// Every frame of a benchmark in a line of its own, for those who plot frame times themselves.
#pragma once
#include <span>
#include <string>

#include "app/session/frame_times.h"

namespace demolish {

/// A header line and a line for each frame: s simulated at its end, the phase that it lies in, ms by stage,
/// bonds that broke in it, and what it was spent on.
std::string frameCsv(std::span<const FrameSample> samples, std::span<const Phase> phases);

}  // namespace demolish
