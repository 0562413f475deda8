// SPDX-License-Identifier: Apache-2.0
// Constants of the curves.
#include "engine/scene/tone_curve.h"

#include <algorithm>
#include <cmath>

namespace demolish::engine {
namespace {

/// y = x^a, then y / (y^d b + c): contrast a in the middle, shoulder d towards white; b and c follow from
/// where middle grey and white land (Lottes, "Advanced techniques and optimization of HDR color pipelines",
/// GDC 2016).
glm::vec4 filmParameters() {
    constexpr float kContrast = 1.36f, kShoulder = 0.97f, kWhite = 9.0f, kGreyIn = 0.18f, kGreyOut = 0.19f;
    const float grey = std::pow(kGreyIn, kContrast), grey_d = std::pow(kGreyIn, kContrast * kShoulder);
    const float white = std::pow(kWhite, kContrast), white_d = std::pow(kWhite, kContrast * kShoulder);
    const float b = (white * kGreyOut - grey) / ((white_d - grey_d) * kGreyOut);
    const float c = (white_d * grey - white * grey_d * kGreyOut) / ((white_d - grey_d) * kGreyOut);
    return {kContrast, kShoulder, b, c};
}

/// A sigmoid of stops from middle grey, from black at the darkest to white at the brightest.
ToneParameters agxParameters() {
    constexpr float kGrey = 0.18f, kDarkest = -10.0f, kBrightest = 6.5f, kSlope = 2.2f, kPower = 1.5f;
    const float range = kBrightest - kDarkest, shown = std::pow(kGrey, 1 / 2.2f);
    const auto bend = [&](float reach, float room) {
        return std::pow(std::pow(kSlope * reach / room, kPower) - 1, 1 / kPower) / reach;
    };
    return {{kSlope, kPower, bend(-kDarkest / range, shown), bend(kBrightest / range, 1 - shown)},
            {1 / range, -std::log2(kGrey) / range, shown, 0}};
}

float agxOfGrey(float light) {
    const ToneParameters p = agxParameters();
    const float x = std::log2(std::max(light, 1e-6f)) * p.second.x + p.second.y;
    const float bent = (x < 0 ? p.first.z : p.first.w) * std::abs(x);
    const float y = p.second.z + p.first.x * x / std::pow(1 + std::pow(bent, p.first.y), 1 / p.first.y);
    return std::pow(std::clamp(y, 0.0f, 1.0f), 2.2f);
}

}  // namespace

ToneParameters toneParameters(ToneCurve curve) {
    return curve == ToneCurve::kAgx ? agxParameters() : ToneParameters{filmParameters(), {}};
}

float toneOfGrey(ToneCurve curve, float light) {
    const float c = std::max(light, 0.0f);
    switch (curve) {
        case ToneCurve::kFilm: {
            const glm::vec4 p = filmParameters();
            const float y = std::pow(std::max(c, 1e-5f), p.x);
            return std::min(1.0f, y / (std::pow(y, p.y) * p.z + p.w));
        }
        case ToneCurve::kAgx:
            return agxOfGrey(c);
        case ToneCurve::kNeutral: {
            constexpr float kStart = 0.8f - 0.04f, kRest = 1 - kStart;
            const float offset = c < 0.08f ? c - 6.25f * c * c : 0.04f, peak = c - offset;
            return peak < kStart ? peak : 1 - kRest * kRest / (peak + kRest - kStart);
        }
        case ToneCurve::kNone:
            break;
    }
    return std::min(c, 1.0f);
}

}  // namespace demolish::engine
