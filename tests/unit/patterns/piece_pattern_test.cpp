// SPDX-License-Identifier: Apache-2.0
// What patterns of pieces promise: sizes, shapes, and that they turn with their frame.
#include "sim_cuda/patterns/fit_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace demolish {
namespace {

constexpr float kStep = 0.1f;

PatternFrame upright() {
    return patternFrame({0, 0, 0}, {0, 0, 1});
}

struct Extent {
    Vec3<float> low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
    size_t points = 0;

    void add(const Vec3<float>& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        ++points;
    }
    Vec3<float> size() const { return high - low; }
    bool touches(float wall) const {
        const auto beyond = [wall](float v) { return v > wall || v < -wall; };
        return beyond(low.x) || beyond(low.y) || beyond(low.z) || beyond(high.x) || beyond(high.y) ||
               beyond(high.z);
    }
};

/// Pieces of size 1 in a cube of edge 2 `half`, by their words.
std::map<uint32_t, Extent> piecesIn(Pattern kind, float half) {
    std::map<uint32_t, Extent> pieces;
    const PiecePattern pattern{kind, 1, 7};
    for (float x = -half; x <= half; x += kStep)
        for (float y = -half; y <= half; y += kStep)
            for (float z = -half; z <= half; z += kStep)
                pieces[pieceAt(pattern, upright(), {x, y, z})].add({x, y, z});
    return pieces;
}

/// Mean volume and size of the pieces that no wall of the cube cuts.
struct Mean {
    double volume = 0;
    Vec3<float> size;
};
Mean meanOf(const std::map<uint32_t, Extent>& pieces, float half) {
    Mean mean;
    size_t count = 0;
    for (const auto& [word, piece] : pieces) {
        if (piece.touches(half - 1.5f * kStep)) continue;
        mean.volume += static_cast<double>(piece.points);
        mean.size = mean.size + piece.size();
        ++count;
    }
    EXPECT_GT(count, 5u);
    mean.volume *= 1e-3 / static_cast<double>(count);
    mean.size = (1.0f / static_cast<float>(count)) * mean.size;
    return mean;
}

TEST(PiecePattern, PiecesHaveTheSizeThatIsAskedFor) {
    EXPECT_NEAR(meanOf(piecesIn(Pattern::kUniform, 3), 3).volume, 1, 0.15);
    EXPECT_NEAR(meanOf(piecesIn(Pattern::kBricks, 3), 3).volume, 1, 0.15);
    EXPECT_NEAR(meanOf(piecesIn(Pattern::kSplinters, 5), 5).volume, 1, 0.2);
}

/// A plate 1 m wide and high and 0.02 m thick, a point every 0.02 m: 2,500.
std::vector<Vec4<float>> plate() {
    std::vector<Vec4<float>> places;
    for (int x = 0; x < 50; ++x)
        for (int y = 0; y < 50; ++y) places.push_back({0.02f * float(x), 0.02f * float(y), 0, 0});
    return places;
}

TEST(PiecePattern, AThinWallComesApartIntoAsManyAsAreAskedFor) {
    const std::vector<Vec4<float>> places = plate();
    for (const Pattern kind : {Pattern::kUniform, Pattern::kRadial, Pattern::kBricks, Pattern::kSplinters})
        for (const uint32_t pieces : {6u, 20u, 60u}) {
            const PiecePattern by_volume{kind, static_cast<float>(std::cbrt(0.02 / pieces)), 5};
            const PatternFrame frame = patternFrame({0.5f, 0.5f, 0}, {0, 1, 0});
            const PiecePattern fitted = fittedPattern(by_volume, frame, places, pieces);
            EXPECT_NEAR(double(countPieces(fitted, frame, places)), pieces, 1 + 0.15 * pieces)
                << int(kind) << ", by volume " << countPieces(by_volume, frame, places);
            EXPECT_GT(countPieces(by_volume, frame, places), 1.3 * pieces);
        }
}

TEST(PiecePattern, OnePieceIsAllOfTheBody) {
    const std::vector<Vec4<float>> places = plate();
    for (const Pattern kind :
         {Pattern::kUniform, Pattern::kRadial, Pattern::kSlabs, Pattern::kBricks, Pattern::kSplinters})
        for (const Vec3<float>& centre : {Vec3<float>{0.5f, 0.5f, 0}, Vec3<float>{0, 0.5f, 0}}) {
            const PatternFrame frame = patternFrame(centre, {1, 0, 0});
            EXPECT_EQ(countPieces(fittedPattern({kind, 0.3f, 5}, frame, places, 1), frame, places), 1u)
                << int(kind);
        }
}

TEST(PiecePattern, WhatCannotBeCutSoFinelyIsCutAsFinelyAsCanBe) {
    const std::vector<Vec4<float>> few{{0.5f, 0.5f, 0, 0}};
    const PatternFrame frame = patternFrame({}, {0, 1, 0});
    EXPECT_EQ(countPieces(fittedPattern({Pattern::kUniform, 0.1f, 5}, frame, few, 100), frame, few), 1u);
}

TEST(PiecePattern, SplintersAreLongAndBricksLieFlat) {
    const Vec3<float> splinter = meanOf(piecesIn(Pattern::kSplinters, 5), 5).size;
    EXPECT_GT(splinter.z, 3 * splinter.x);
    const Vec3<float> brick = meanOf(piecesIn(Pattern::kBricks, 3), 3).size;
    EXPECT_GT(brick.x, 1.5f * brick.z);
}

TEST(PiecePattern, SlabsLieAcrossTheAxis) {
    for (const auto& [word, slab] : piecesIn(Pattern::kSlabs, 2)) {
        EXPECT_GT(slab.size().x, 3.9f);
        EXPECT_LT(slab.size().z, 1.2f);
    }
}

TEST(PiecePattern, RadialPiecesGrowAwayFromTheAxis) {
    double inner = 0, outer = 0;
    size_t inner_count = 0, outer_count = 0;
    for (const auto& [word, piece] : piecesIn(Pattern::kRadial, 5)) {
        const Vec3<float> middle = 0.5f * (piece.low + piece.high);
        const double from_axis = std::hypot(middle.x, middle.y);
        if (from_axis < 1)
            inner += double(piece.points), ++inner_count;
        else if (from_axis > 3)
            outer += double(piece.points), ++outer_count;
    }
    EXPECT_GT(outer / double(outer_count), 4 * inner / double(inner_count));
}

TEST(PiecePattern, TurnsAndMovesWithItsFrame) {
    const Vec3<float> axis = normalized(Vec3<float>{0.3f, -0.8f, 0.5f});
    const PatternFrame frame = patternFrame({0.5f, 1, -2}, axis);
    EXPECT_NEAR(dot(frame.across, frame.along), 0, 1e-6);
    EXPECT_NEAR(dot(frame.across, frame.axis), 0, 1e-6);
    EXPECT_NEAR(length(frame.along), 1, 1e-6);
    const PiecePattern pattern{Pattern::kBricks, 0.7f, 3};
    for (float t = -3; t < 3; t += 0.37f) {
        const Vec3<float> p{t, 0.3f * t * t, 1 - t};
        const Vec3<float> turned = frame.centre + (p.x * frame.across + p.y * frame.along + p.z * frame.axis);
        EXPECT_EQ(pieceAt(pattern, frame, turned), pieceAt(pattern, upright(), p));
    }
}

/// By that measure a border can be found from both of its sides.
TEST(PiecePattern, APlaceIsOfThePieceThatItIsLeastFarFrom) {
    for (const Pattern kind :
         {Pattern::kUniform, Pattern::kRadial, Pattern::kSlabs, Pattern::kBricks, Pattern::kSplinters}) {
        const PiecePattern pattern{kind, 1, 7};
        const auto pieces = piecesIn(kind, 1.5f);
        ASSERT_GT(pieces.size(), 2u);
        for (float t = 0; t < 1; t += 0.013f) {
            const Vec3<float> place{2.6f * t - 1.3f, 1.9f * t * t - 1, 1.1f - 2.1f * t};
            const uint32_t own = pieceAt(pattern, upright(), place);
            const Vec3<float> p = bentPlace(pattern, upright(), place);
            for (const auto& [word, extent] : pieces)
                EXPECT_GE(farFromPiece(pattern, p, word), farFromPiece(pattern, p, own) - 1e-5f) << int(kind);
        }
    }
}

TEST(PiecePattern, FramesStandForAxesInEveryDirection) {
    for (const Vec3<float>& axis : {Vec3<float>{0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}) {
        const PatternFrame frame = patternFrame({}, axis);
        EXPECT_NEAR(length(cross(frame.across, frame.along) - axis), 0, 1e-6);
    }
}

}  // namespace
}  // namespace demolish
