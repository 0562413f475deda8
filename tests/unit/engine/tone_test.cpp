// SPDX-License-Identifier: Apache-2.0
// Tone curves and white balance: what they promise of grey and of coloured light.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/scene/tone_curve.h"
#include "engine/scene/white_balance.h"

namespace demolish::engine {
namespace {

constexpr ToneCurve kCurves[] = {ToneCurve::kFilm, ToneCurve::kAgx, ToneCurve::kNeutral, ToneCurve::kNone};

TEST(ToneCurves, GrowFromBlackToWhite) {
    for (const ToneCurve curve : kCurves) {
        EXPECT_LT(toneOfGrey(curve, 0), 1e-3f);
        EXPECT_GT(toneOfGrey(curve, 30), 0.97f);
        float last = -1;
        for (float stop = -11; stop < 6; stop += 0.125f) {
            const float shown = toneOfGrey(curve, 0.18f * std::exp2(stop));
            EXPECT_GE(shown, last);
            EXPECT_LE(shown, 1);
            last = shown;
        }
    }
}

TEST(ToneCurves, ShowMiddleGreyWhereTheySay) {
    EXPECT_NEAR(toneOfGrey(ToneCurve::kFilm, 0.18f), 0.19f, 0.002f);
    EXPECT_NEAR(toneOfGrey(ToneCurve::kAgx, 0.18f), 0.18f, 0.002f);
    EXPECT_NEAR(toneOfGrey(ToneCurve::kNeutral, 0.18f), 0.14f,
                0.002f);  // without the 4 % that it takes for gloss
    EXPECT_EQ(toneOfGrey(ToneCurve::kNone, 0.18f), 0.18f);
}

TEST(ToneCurves, KeepDetailInWhatIsBrighterThanWhite) {
    for (const ToneCurve curve : {ToneCurve::kFilm, ToneCurve::kAgx, ToneCurve::kNeutral})
        EXPECT_LT(toneOfGrey(curve, 1.5f), toneOfGrey(curve, 3) - 0.01f);
}

TEST(WhiteBalance, LeavesDaylightAndGreysTheLightItIsSetTo) {
    EXPECT_LT(glm::length(whiteBalance(kDaylight) - glm::vec3(1)), 1e-5f);
    const glm::vec3 warm = whiteBalance(3200), cool = whiteBalance(10000);
    EXPECT_LT(warm.x, warm.y);  // red light is taken back
    EXPECT_GT(warm.z, warm.y);
    EXPECT_GT(cool.x, cool.z);
    for (const float t : {kLeastTemperature, 2500.0f, 4000.0f, kMostTemperature}) {
        const glm::vec3 gains = whiteBalance(t);
        EXPECT_NEAR(glm::dot(gains, glm::vec3(0.2126f, 0.7152f, 0.0722f)), 1, 1e-4f);
        EXPECT_GT(std::min({gains.x, gains.y, gains.z}), 0);
    }
    // Continuous where one cubic ends and the next begins.
    EXPECT_LT(glm::length(whiteBalance(3999) - whiteBalance(4001)), 0.02f);
}

}  // namespace
}  // namespace demolish::engine
