// SPDX-License-Identifier: Apache-2.0
// Colours that an artist has painted at a model's vertices, taken as strength.
#pragma once
#include <cstdint>

namespace demolish {

enum class PaintChannel : uint8_t { kRed, kGreen, kBlue, kAlpha };

/// Bonds below white are as strong as ever, those below what is dark in this channel are weaker.
struct PaintedStrength {
    PaintChannel channel = PaintChannel::kRed;
    double least = 0.1;  ///< times the strength of bonds where the channel is 0; 0.01 to 1
    bool operator==(const PaintedStrength&) const = default;
};

}  // namespace demolish
