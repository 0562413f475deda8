// SPDX-License-Identifier: Apache-2.0
// Waves of a break: as high as is said, without steps, across the break alone, and none where a piece is
// small or the outside is.
#include "sim_cuda/kernels/break_waves.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "sim_cuda/kernels/wave_pool_vertices.h"

namespace demolish {
namespace {

TEST(BreakWaves, AreAsHighAsSaidAndWithoutSteps) {
    constexpr float kHeight = 0.03f, kSpacing = 0.1f;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-2, 2);
    float highest = 0;
    for (int n = 0; n < 20'000; ++n) {
        const Vec3<float> p{place(random), place(random), place(random)};
        const Vec3<float> here = breakWaves(p, kSpacing, kHeight);
        highest = maxOf(highest, maxOf(maxOf(here.x, -here.x), maxOf(here.y, -here.y)));
        const Vec3<float> beside = breakWaves({p.x + 1e-3f * kSpacing, p.y, p.z}, kSpacing, kHeight);
        EXPECT_LT(length(beside - here), 4e-3f * kHeight);
    }
    EXPECT_LE(highest, 1.57f * kHeight);
    EXPECT_GT(highest, 0.9f * kHeight);
    EXPECT_EQ(length(breakWaves({0.3f, 0.2f, 0.1f}, kSpacing, 0)), 0);
}

/// A vertex in the middle of four corners in the plane z = 1, each a part of a face of its own.
struct Fan {
    std::vector<uint32_t> start{0, 4, 4, 4, 4, 4}, face{0, 1, 2, 3}, next{1, 2, 3, 4}, previous{2, 3, 4, 1};
    std::vector<uint8_t> state{kFaceNew, kFaceNew, kFaceNew, kFaceNew};
    std::vector<uint8_t> surface_distance = std::vector<uint8_t>(5, kInnerDistance);
    std::vector<uint32_t> pieces = std::vector<uint32_t>(5, 1000);
    std::vector<Float3> rest{{0.2f, 0.1f, 1}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};
    std::vector<float> spacing = std::vector<float>(5, 0.5f), waves = std::vector<float>(5, 0.2f);

    Float3 waved() const {
        const auto view = [](const auto& values) { return Span(values.data(), values.size()); };
        std::vector<Float3> position = rest;
        const WavePoolVertices wave{{view(start), view(face), view(next), view(previous)},
                                    view(state),
                                    view(surface_distance),
                                    view(pieces),
                                    view(rest),
                                    view(spacing),
                                    view(waves),
                                    view(rest),
                                    Span(position.data(), position.size())};
        wave(0);
        return position[0];
    }
};

TEST(BreakWaves, CrossTheBreakWhicheverWayItsPartsAreWound) {
    Fan fan;
    const Float3 waved = fan.waved();
    EXPECT_NEAR(waved.x, fan.rest[0].x, 1e-6);
    EXPECT_NEAR(waved.y, fan.rest[0].y, 1e-6);
    EXPECT_NEAR(waved.z, 1 + breakWaves({0.2f, 0.1f, 1}, 0.5f, 0.2f).z, 1e-6);
    EXPECT_GT(std::abs(waved.z - 1), 0.01);
    std::swap(fan.next[1], fan.previous[1]);
    EXPECT_NEAR(fan.waved().z, waved.z, 1e-6);
    fan.state[2] = kFaceHidden;
    EXPECT_NEAR(fan.waved().z, waved.z, 1e-6) << "the other parts have the same plane";
}

TEST(BreakWaves, AreNotWhereAPieceIsSmallOrTheOutsideBegins) {
    Fan small;
    small.pieces[0] = kMostCellsPlaned;
    EXPECT_EQ(small.waved().z, 1);
    Fan at_rim;
    at_rim.surface_distance[0] = 0;
    EXPECT_EQ(at_rim.waved().z, 1);
    Fan even;
    even.waves[0] = 0;
    EXPECT_EQ(even.waved().z, 1);
}

}  // namespace
}  // namespace demolish
