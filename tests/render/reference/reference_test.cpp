// SPDX-License-Identifier: Apache-2.0
// A path tracer that knows nothing of ours sees the same frame: pieces, camera, sun, surroundings and
// exposure are what we say that they are.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/image/compare.h"
#include "tests/render/reference/reference_shot.h"

namespace demolish::reference {
namespace {

/// Mean of the picture's linear light, Rec. 709 luma, from `first_row` down.
double meanLight(const engine::Image& image, int first_row) {
    const auto linear = [](uint8_t value) {
        const double s = value / 255.0;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    double sum = 0;
    for (int y = first_row; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const uint8_t* p = image.at(x, y);
            sum += 0.2126 * linear(p[0]) + 0.7152 * linear(p[1]) + 0.0722 * linear(p[2]);
        }
    return sum / (static_cast<double>(image.height - first_row) * image.width);
}

TEST(Reference, APathTracerSeesTheSameFrame) {
    if (!hasBlender()) GTEST_SKIP() << "blender is not installed";
    ShotOptions options;
    options.scene = "bunny";
    options.particles = 300;
    const ReferenceShot shot = takeShot(options, 0.7, {192, 108});
    const std::filesystem::path folder = DEMOLISH_REFERENCE_OUT;
    writeShot(shot, folder);
    const engine::Image traced = pathTraced(folder, 48);
    ASSERT_EQ(traced.width, shot.ours.width);
    ASSERT_EQ(traced.height, shot.ours.height);
    const double ratio = meanLight(shot.ours, 0) / meanLight(traced, 0);
    const double likeness = engine::structuralSimilarity(shot.ours, traced);
    RecordProperty("light_ratio", std::to_string(ratio));
    RecordProperty("similarity", std::to_string(likeness));
    EXPECT_NEAR(ratio, 1.0, 0.07);
    EXPECT_GT(likeness, 0.85);
}

}  // namespace
}  // namespace demolish::reference
