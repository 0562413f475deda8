// SPDX-License-Identifier: Apache-2.0
// What lies behind others is left out where that is sure, and nothing else is.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "engine/render/hidden_triangles.h"

namespace demolish::engine {
namespace {

constexpr int kSize = 16;

struct Flat {
    float left, low, edge, near;
};

/// A right angle in the lower left corner.
std::array<PicturePoint, 3> cornersOf(const Flat& f) {
    return {{{f.left, f.low, 1, f.near},
             {f.left + f.edge, f.low, 1, f.near},
             {f.left, f.low + f.edge, 1, f.near}}};
}

/// Numbers of the triangles that stay.
std::vector<uint32_t> seenOf(const std::vector<std::array<PicturePoint, 3>>& triangles) {
    const SampleGrid grid(glm::mat4(1), kSize, kSize);
    NearestSurely nearest;
    nearest.clear(grid.sampleCount());
    Candidates candidates;
    for (uint32_t k = 0; k < triangles.size(); ++k) {
        const auto& [a, b, c] = triangles[k];
        Cover cover;
        const Cover::Kind kind = grid.findCover(a, b, c, true, cover);
        if (kind == Cover::Kind::kAnything)
            candidates.addShown({k, k, k});
        else if (kind == Cover::Kind::kSamples)
            candidates.add({k, k, k}, triangles[k], cover, grid, nearest);
    }
    std::vector<uint32_t> indices, seen;
    candidates.keepSeen(nearest, indices);
    for (size_t i = 0; i < indices.size(); i += 3) seen.push_back(indices[i]);
    return seen;
}

TEST(HiddenTriangles, WhatLiesBehindGoesInAnyOrder) {
    const auto behind = cornersOf({5.2f, 5.2f, 1.5f, 0.3f}), before = cornersOf({4.2f, 4.2f, 3.9f, 0.6f});
    EXPECT_EQ(seenOf({behind, before}), (std::vector<uint32_t>{1}));
    EXPECT_EQ(seenOf({before, behind}), (std::vector<uint32_t>{0}));
}

TEST(HiddenTriangles, WhatLooksOutStays) {
    const auto large = cornersOf({4.2f, 4.2f, 3.9f, 0.6f});
    EXPECT_EQ(seenOf({cornersOf({3.2f, 5.2f, 2, 0.3f}), large}).size(), 2u);
    EXPECT_EQ(seenOf({cornersOf({5.2f, 5.2f, 1.5f, 0.6f}), large}).size(), 2u) << "as near";
    EXPECT_EQ(seenOf({cornersOf({5.2f, 5.2f, 1.5f, 0.7f}), large}).size(), 2u) << "nearer";
}

TEST(HiddenTriangles, ASampleOnAnEdgeIsNotSurelyCovered) {
    // The right angle of the near one is a sample: another rounding puts it outside.
    const auto before = cornersOf({5.5f, 5.5f, 3, 0.6f});
    EXPECT_EQ(seenOf({cornersOf({5.4f, 5.4f, 0.3f, 0.3f}), before}).size(), 2u);
}

TEST(HiddenTriangles, WhatIsCutOffHidesNothing) {
    auto cut = cornersOf({4.2f, 4.2f, 3.9f, 0.9f});
    cut[0].near = 1.1f;  // nearer than the near plane
    EXPECT_EQ(seenOf({cornersOf({5.2f, 5.2f, 1.5f, 0.3f}), cut}).size(), 2u);
}

TEST(HiddenTriangles, WhereAPlaceIsNotSureNothingIsHidden) {
    auto before = cornersOf({4.2f, 4.2f, 3.9f, 0.6f});
    for (PicturePoint& p : before) p.near_unsure = 0.4f;
    EXPECT_EQ(seenOf({cornersOf({5.2f, 5.2f, 1.5f, 0.3f}), before}).size(), 2u);
}

}  // namespace
}  // namespace demolish::engine
