// SPDX-License-Identifier: Apache-2.0
// Pictures are spread over pixel and lens by an additive recurrence of the plastic numbers (Roberts 2018),
// and evenly over time.
#include "engine/scene/lens.h"

#include <cmath>
#include <numbers>

namespace demolish::engine {
namespace {

constexpr uint32_t kUsualPictures = 16;
constexpr double kSensorHalf = 0.012;          // m
constexpr double kRoot = 1.16730397826141868;  // of x^5 = x + 1: four dimensions
constexpr float kGoldenShare = 0.61803398875f;

/// The i-th number of a dimension from 1 on, 0..1.
float spread(uint32_t i, int dimension) {
    const double value = 0.5 + (i + 1) * std::pow(kRoot, -dimension);
    return static_cast<float>(value - std::floor(value));
}

}  // namespace

uint32_t picturesOf(const Lens& lens) {
    if (lens.samples > 0) return lens.samples;
    return lens.aperture > 0 || lens.shutter > 0 ? kUsualPictures : 1;
}

float apertureRadius(const Lens& lens, const Camera& camera) {
    if (lens.aperture <= 0) return 0;
    const double focal_length = kSensorHalf / std::tan(0.5 * static_cast<double>(camera.field_of_view));
    return static_cast<float>(0.5 * focal_length / static_cast<double>(lens.aperture));
}

FrameView pictureView(const FrameView& frame, const Lens& lens, uint32_t i, uint32_t n) {
    FrameView view = frame;
    view.radiance = true;
    if (n > 1) view.jitter = glm::vec2(spread(i, 1), spread(i, 2)) - 0.5f;
    const float turn = 2 * std::numbers::pi_v<float> * spread(i, 3);
    const float radius = apertureRadius(lens, frame.camera) * std::sqrt(spread(i, 4));
    view.lens_offset = radius * glm::vec2(std::cos(turn), std::sin(turn));
    view.focus_distance = lens.focus > 0 ? lens.focus : glm::length(frame.camera.target - frame.camera.eye);
    view.noise_turn = kGoldenShare * static_cast<float>(i) - std::floor(kGoldenShare * static_cast<float>(i));
    return view;
}

float pictureMoment(const Lens& lens, uint32_t i, uint32_t n) {
    return 1 - lens.shutter * (1 - (static_cast<float>(i) + 0.5f) / static_cast<float>(n));
}

Opening pictureOpening(const Lens& lens, float frame_s, uint32_t i, uint32_t n) {
    if (lens.shutter <= 0 || frame_s <= 0) return {};
    const float pictures = static_cast<float>(n), half = 0.5f * lens.shutter * frame_s / pictures;
    return {{-half, half}, glm::vec2(i, i + 1) / pictures};
}

}  // namespace demolish::engine
