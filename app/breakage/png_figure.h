// SPDX-License-Identifier: Apache-2.0
// Figures as PNG, for readers that do not show SVG: drawn by the program rsvg-convert.
#pragma once
#include <filesystem>

namespace demolish {

/// Writes FIGURE.png beside FIGURE.svg, with twice as many pixels a side; whole or not at all. False when
/// there is no rsvg-convert on this machine (package librsvg2-bin). Throws OutputError when it fails.
bool drawAsPng(const std::filesystem::path& svg);

}  // namespace demolish
