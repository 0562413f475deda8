// SPDX-License-Identifier: Apache-2.0
// Two measures: how many pixels are plainly wrong, and whether the structure is the same.
#include "engine/image/compare.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace demolish::engine {
namespace {

constexpr int kWindow = 8, kStride = 4;

double luma(const uint8_t* p) {
    return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

/// SSIM of one window (Wang et al. 2004, eq. 13) on 8-bit values.
double windowSimilarity(const Image& a, const Image& b, int left, int top, int width, int height) {
    double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
    for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x) {
            const double va = luma(a.at(x, y)), vb = luma(b.at(x, y));
            sum_a += va;
            sum_b += vb;
            sum_aa += va * va;
            sum_bb += vb * vb;
            sum_ab += va * vb;
        }
    }
    const double n = static_cast<double>(width) * height;
    const double mean_a = sum_a / n, mean_b = sum_b / n;
    const double variance_a = sum_aa / n - mean_a * mean_a, variance_b = sum_bb / n - mean_b * mean_b;
    const double covariance = sum_ab / n - mean_a * mean_b;
    constexpr double kC1 = (0.01 * 255) * (0.01 * 255), kC2 = (0.03 * 255) * (0.03 * 255);
    return (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) /
           ((mean_a * mean_a + mean_b * mean_b + kC1) * (variance_a + variance_b + kC2));
}

}  // namespace

double structuralSimilarity(const Image& image, const Image& reference) {
    assert(image.width == reference.width && image.height == reference.height);
    const int width = std::min(kWindow, image.width), height = std::min(kWindow, image.height);
    double sum = 0.0;
    size_t windows = 0;
    for (int y = 0; y + height <= image.height; y += kStride) {
        for (int x = 0; x + width <= image.width; x += kStride) {
            sum += windowSimilarity(image, reference, x, y, width, height);
            ++windows;
        }
    }
    return windows > 0 ? sum / static_cast<double>(windows) : 1.0;
}

Comparison compare(const Image& image, const Image& reference, const CompareLimits& limits) {
    Comparison result;
    result.same_size = image.width == reference.width && image.height == reference.height;
    if (!result.same_size || image.pixels.empty()) return result;
    size_t wrong = 0;
    result.largest_difference = 0;
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        int difference = 0;
        for (size_t c = 0; c < 3; ++c) {
            difference = std::max(difference, std::abs(image.pixels[i + c] - reference.pixels[i + c]));
        }
        result.largest_difference = std::max(result.largest_difference, difference);
        if (difference > limits.channel_difference) ++wrong;
    }
    const size_t pixel_count = image.pixels.size() / 4;
    result.wrong_fraction = static_cast<double>(wrong) / static_cast<double>(pixel_count);
    result.ssim = structuralSimilarity(image, reference);
    result.passed = result.wrong_fraction <= limits.wrong_fraction && result.ssim >= limits.ssim;
    return result;
}

Image differencePicture(const Image& image, const Image& reference, int gain) {
    assert(image.width == reference.width && image.height == reference.height);
    Image result(image.width, image.height);
    for (size_t i = 0; i < result.pixels.size(); ++i) {
        if (i % 4 == 3) continue;
        result.pixels[i] =
            static_cast<uint8_t>(std::min(255, gain * std::abs(image.pixels[i] - reference.pixels[i])));
    }
    return result;
}

}  // namespace demolish::engine
