// SPDX-License-Identifier: Apache-2.0
// Pieces of a few cells look like splinters of stone, not like grapes: few flat faces, hardly a dent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/draw/drawn_surface.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

using Vec = Vec3<double>;

Vec vec(const Float3& p) {
    return {p.x, p.y, p.z};
}

/// Unit, spread evenly.
std::vector<Vec> directions() {
    constexpr int kCount = 200;
    std::vector<Vec> spread;
    for (int k = 0; k < kCount; ++k) {
        const double z = 1 - (2 * k + 1.0) / kCount, around = 2.399963 * k, r = std::sqrt(1 - z * z);
        spread.push_back({r * std::cos(around), r * std::sin(around), z});
    }
    return spread;
}

/// m, rms: how deep the corners of a closed surface lie below its hull.
double depthBelowHull(const test::Soup& soup) {
    double sum = 0, corners = 0;
    std::vector<double> depth(3 * soup.size(), 1e30);
    for (const Vec& direction : directions()) {
        double farthest = -1e30;
        for (const auto& triangle : soup)
            for (const Float3& p : triangle) farthest = std::max(farthest, dot(direction, vec(p)));
        size_t at = 0;
        for (const auto& triangle : soup)
            for (const Float3& p : triangle) {
                depth[at] = std::min(depth[at], farthest - dot(direction, vec(p)));
                ++at;
            }
    }
    for (const double below : depth) {
        sum += below * below;
        corners += 1;
    }
    return std::sqrt(sum / corners);
}

class PiecePlanes : public testing::Test {
  protected:
    static constexpr uint32_t kCells = 3000, kPieces = 400;

    PiecePlanes() {
        FillOptions options;
        options.particles = kCells;
        body_ = fillWithParticles(SolidMesh(test::makeSphere(0.5, 4)), options);
        pieces_ = test::randomFragments(body_->geometry, kCells, kPieces, 1);
        drawn_ = std::make_unique<test::DrawnSurface>(test::sceneOf(body_));
        drawn_->show(pieces_);
    }
    /// Of `least` to `most` cells, none of them on the outside.
    std::vector<uint32_t> inside(uint32_t least, uint32_t most) const {
        std::vector<bool> is_outside(kPieces, false);
        for (const SurfaceVertex& vertex : body_->geometry.exterior) is_outside[pieces_[vertex.cell]] = true;
        std::vector<uint32_t> found;
        for (uint32_t piece = 0; piece < kPieces; ++piece) {
            const uint32_t cells = drawn_->fragment_sizes[piece];
            if (!is_outside[piece] && cells >= least && cells <= most) found.push_back(piece);
        }
        return found;
    }

    std::shared_ptr<const BreakableBody> body_;
    std::vector<uint32_t> pieces_;
    std::unique_ptr<test::DrawnSurface> drawn_;
};

TEST_F(PiecePlanes, PiecesOfAFewCellsHaveHardlyADent) {
    const std::vector<test::Soup> drawn = drawn_->soups(kPieces),
                                  as_cut = test::fragmentSurfaces(body_->geometry, pieces_, kPieces,
                                                                  body_->geometry.pool);
    double depth = 0, depth_cut = 0, volume = 0, volume_cut = 0;
    const std::vector<uint32_t> few = inside(2, kMostCellsPlaned);
    ASSERT_GT(few.size(), 20u);
    for (const uint32_t piece : few) {
        EXPECT_EQ(test::openEdges(drawn[piece]), 0u);
        depth += depthBelowHull(drawn[piece]);
        depth_cut += depthBelowHull(as_cut[piece]);
        volume += test::enclosedVolume(drawn[piece]);
        volume_cut += test::enclosedVolume(as_cut[piece]);
        EXPECT_GT(test::enclosedVolume(drawn[piece]), 0.5 * test::enclosedVolume(as_cut[piece]));
    }
    EXPECT_LT(depth, 0.6 * depth_cut) << "0.5, and 0.73 of smoothed ones without planes";
    EXPECT_NEAR(volume / volume_cut, 1, 0.1);
}

}  // namespace
}  // namespace demolish
