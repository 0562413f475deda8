// SPDX-License-Identifier: Apache-2.0
// Is this picture that picture? The rule of golden pictures, and a difference picture for people.
#pragma once
#include "engine/image/image.h"

namespace demolish::engine {

/// Limits of a golden comparison; both must hold.
struct CompareLimits {
    int channel_difference = 5;     ///< of 255, a pixel beyond it in any of R, G, B is wrong
    double wrong_fraction = 0.002;  ///< pixels that may be wrong
    double ssim = 0.985;            ///< least mean structural similarity of the luma
};

struct Comparison {
    bool same_size = false;
    double wrong_fraction = 1.0;
    int largest_difference = 255;  ///< of 255
    double ssim = 0.0;
    bool passed = false;
};

Comparison compare(const Image& image, const Image& reference, const CompareLimits& limits = {});

/// Mean SSIM of the luma over 8 x 8 windows, stride 4 (Wang et al. 2004, K1 = 0.01, K2 = 0.03). Sizes must be
/// equal.
double structuralSimilarity(const Image& image, const Image& reference);

/// |image - reference| times `gain`, clamped. Sizes must be equal.
Image differencePicture(const Image& image, const Image& reference, int gain = 16);

}  // namespace demolish::engine
