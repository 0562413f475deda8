// SPDX-License-Identifier: Apache-2.0
// The corners of a cell on a shape, looked at by one thread or shared among several: the same bits. What
// lanes of a GPU hand each other is done here by hand.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <vector>

#include "sim_cuda/kernels/press_on_shape.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::tests {
namespace {

using Found = PointsPressed<float>;

std::array<uint32_t, 12> bitsOf(const Found& found) {
    const DepthSums<float>& sums = found.sums;
    std::array<uint32_t, 12> bits{};
    size_t used = 0;
    for (const float number :
         {sums.force, sums.energy, sums.nearest, sums.arm.x, sums.arm.y, sums.arm.z, found.normal.x,
          found.normal.y, found.normal.z, found.turning.x, found.turning.y, found.turning.z})
        bits[used++] = std::bit_cast<uint32_t>(number);
    return bits;
}

/// As a warp does it: every lane adds what the one across has.
Found folded(std::vector<Found> lanes) {
    for (size_t half = lanes.size() / 2; half > 0; half /= 2) {
        const std::vector<Found> before = lanes;
        for (size_t k = 0; k < lanes.size(); ++k) add<false>(lanes[k], before[k ^ half]);
    }
    for (const Found& lane : lanes) EXPECT_EQ(bitsOf(lane), bitsOf(lanes[0]));
    return lanes[0];
}

template <uint32_t kLanes, bool kLedger, class Shape>
Found byLanes(const Shape& shape, const CellPose<float>& cell) {
    const CornerLook<kLedger, true, float, Shape> look(shape, cell);
    const OwnCorners<float>& corners = cell.seen.corners;
    std::vector<Found> lanes;
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
        if constexpr (kLanes == kCornerParts) {
            lanes.push_back(lookOnce(look, corners, lane).points);
        } else {
            const LaneGroup<kLanes> group{lane};
            float nearest = kFarAway;
            const uint32_t touching = kLedger
                                          ? lowBits(static_cast<uint32_t>(corners.from_seed.size()))
                                          : cornersThatMayTouch(corners, look.axes(), shape, group, nearest);
            lanes.push_back(lookTwice<kLedger>(look, corners, group, touching));
            lanes.back().sums.nearest = minOf(lanes.back().sums.nearest, nearest);
        }
    }
    return folded(std::move(lanes));
}

/// A cell of up to kMostCorners corners that are strewn about its seed.
class StrewnCells {
  public:
    CellPose<float> next(std::vector<Vec4<float>>& corners) {
        corners.resize(4 + random_() % (kMostCorners - 3));
        for (Vec4<float>& corner : corners) corner = {0.1f * one(), 0.1f * one(), 0.1f * one(), 0};
        CellPose<float> cell{};
        cell.high = {0.6f * one(), 0.6f * one(), 0.6f * one()};
        cell.seen.corners = {{corners.data(), corners.size()}, 0.05f};
        cell.seen.turned = normalized(Quat<float>{one(), one(), one(), one()});
        cell.seen.drift = 1e-4f;
        cell.velocity = {one(), one(), one()};
        cell.spin = {one(), one(), one()};
        return cell;
    }

  private:
    float one() { return uniform_(random_); }
    std::mt19937 random_{7};
    std::uniform_real_distribution<float> uniform_{-1, 1};
};

template <class Shape>
void expectSameBits(const Collider& collider) {
    const ColliderRows<float> rows = makeColliderSet<float>({collider}).collider[0];
    const Shape shape{rows};
    StrewnCells cells;
    std::vector<Vec4<float>> corners;
    int pressed = 0;
    for (int k = 0; k < 3000; ++k) {
        const CellPose<float> cell = cells.next(corners);
        const Found alone = byLanes<1, false>(shape, cell);
        pressed += alone.sums.touches();
        ASSERT_EQ(bitsOf(alone), bitsOf(byLanes<2, false>(shape, cell)));
        ASSERT_EQ(bitsOf(alone), bitsOf(byLanes<4, false>(shape, cell)));
        ASSERT_EQ(bitsOf(alone), bitsOf(byLanes<16, false>(shape, cell)));
        ASSERT_EQ(bitsOf(alone), bitsOf(byLanes<1, true>(shape, cell))) << "watched";
    }
    EXPECT_GT(pressed, 300);
    EXPECT_LT(pressed, 2900);
}

TEST(SharedCorners, OnABox) {
    expectSameBits<CornersOnBox<float>>(Box{{0.8, 0.7, 0.9}, {0.1, 0, 0}, {0.1, 0.2, 0.3, 0.92736185}});
}
TEST(SharedCorners, OnACapsule) {
    expectSameBits<CornersOnRound<float>>(Capsule{0.3, {-0.3, 0, 0}, {0.3, 0.1, 0}});
}
TEST(SharedCorners, OnAMesh) {
    const auto mesh = makeColliderMesh(test::makeSphere(0.5, 3), "test.obj", {.repair = {}, .cells = 48});
    expectSameBits<CornersOnMesh<float>>(MeshShape{mesh, 1, {}, {}});
}

/// The centre is looked at by the thread whose turn is after the last corner, and gives what it gives alone.
TEST(SharedCorners, OneOfThemLooksAtTheCentre) {
    const auto mesh = makeColliderMesh(test::makeSphere(0.5, 3), "test.obj", {.repair = {}, .cells = 48});
    const auto set = makeColliderSet<float>({MeshShape{mesh, 1, {}, {}}});
    const CornersOnMesh<float> shape{set.collider[0]};
    StrewnCells cells;
    std::vector<Vec4<float>> corners;
    for (int k = 0; k < 1000; ++k) {
        const CellPose<float> cell = cells.next(corners);
        const CornerLook<false, true, float, CornersOnMesh<float>> look(shape, cell);
        const TangentPlane<float> alone = set.tangent(0, cell.high, cell.low);
        uint32_t lookers = 0;
        for (uint32_t part = 0; part < kCornerParts; ++part) {
            const ShapeFound<float> found = lookOnce(look, cell.seen.corners, part);
            if (!found.has_centre) continue;
            ++lookers;
            EXPECT_EQ(part, corners.size() % kCornerParts);
            const Vec3<float> out = turnedOut(set.collider[0].row, found.centre.out);
            ASSERT_EQ(found.centre.distance, alone.distance);
            ASSERT_EQ(out.x, alone.plane.x);
            ASSERT_EQ(out.y, alone.plane.y);
            ASSERT_EQ(out.z, alone.plane.z);
        }
        EXPECT_EQ(lookers, 1u);
    }
}

}  // namespace
}  // namespace demolish::tests
