// SPDX-License-Identifier: Apache-2.0
// Signed distance and outward normal of each shape against closed forms, far away, near and inside.
#include "sim_cuda/data/colliders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>

namespace demolish::tests {
namespace {

static_assert(std::is_trivially_copyable_v<ColliderSet<float>>);

constexpr double kHalf = 0.7071067811865476;

/// 2 x 4 x 6 m about (1, 2, 3).
const Box kBox{{2, 4, 6}, {1, 2, 3}, {}};

TangentPlane<double> tangent(const Collider& collider, const Vec3<double>& point) {
    return makeColliderSet<double>({collider}).tangent(0, point);
}

struct Row {
    Vec3<double> point;
    double distance;
    Vec3<double> normal;
};

void expectRow(const Collider& collider, const Row& row) {
    SCOPED_TRACE(testing::Message() << row.point.x << ' ' << row.point.y << ' ' << row.point.z);
    const TangentPlane<double> t = tangent(collider, row.point);
    EXPECT_NEAR(t.distance, row.distance, 1e-12 * (1 + std::abs(row.distance)));
    EXPECT_NEAR(t.plane.x, row.normal.x, 1e-12);
    EXPECT_NEAR(t.plane.y, row.normal.y, 1e-12);
    EXPECT_NEAR(t.plane.z, row.normal.z, 1e-12);
    EXPECT_NEAR(dot(xyz(t.plane), row.point) - t.plane.w, row.distance, 1e-9 * (1 + length(row.point)));
}

TEST(Colliders, APlaneIsALinearFunction) {
    const Plane plane{{0.6, 0.8, 0}, 0.5};
    expectRow(plane, {{0, 0, 0}, -0.5, {0.6, 0.8, 0}});
    expectRow(plane, {{1, 1, 7}, 0.9, {0.6, 0.8, 0}});
}

TEST(Colliders, ABoxByItsFaces) {
    expectRow(kBox, {{2.5, 2.5, 3.5}, 0.5, {1, 0, 0}});
    expectRow(kBox, {{-1, 1, 1}, 1, {-1, 0, 0}});
    expectRow(kBox, {{1, 5, 5.9}, 1, {0, 1, 0}});
    expectRow(kBox, {{1, -0.25, 3}, 0.25, {0, -1, 0}});
    expectRow(kBox, {{1.5, 2, 6.125}, 0.125, {0, 0, 1}});
    expectRow(kBox, {{1.5, 2, -100}, 100, {0, 0, -1}});
    expectRow(kBox, {{2, 2, 3}, 0, {1, 0, 0}});
}

TEST(Colliders, ABoxByItsEdgesAndCorners) {
    expectRow(kBox, {{2 + 3, 4 + 4, 3}, 5, {0.6, 0.8, 0}});
    expectRow(kBox, {{0 - 3, 1, 0 - 4}, 5, {-0.6, 0, -0.8}});
    expectRow(kBox, {{2 + 1, 4 + 2, 6 + 2}, 3, {1.0 / 3, 2.0 / 3, 2.0 / 3}});
    expectRow(kBox, {{0 - 2, 0 - 1, 6 + 2}, 3, {-2.0 / 3, -1.0 / 3, 2.0 / 3}});
    expectRow(kBox, {{2 + 1e5, 4 + 1e5, 3}, 1e5 / kHalf, {kHalf, kHalf, 0}});
}

TEST(Colliders, InsideABoxTheNearestFaceCounts) {
    expectRow(kBox, {{1.75, 2, 3}, -0.25, {1, 0, 0}});
    expectRow(kBox, {{1, 0.125, 3}, -0.125, {0, -1, 0}});
    expectRow(kBox, {{1.2, 2, 5.9}, -0.1, {0, 0, 1}});
    EXPECT_EQ(tangent(kBox, {1, 2, 3}).distance, -1) << "the middle: any of the two nearest faces";
}

TEST(Colliders, ATurnedBoxIsTheSameInItsOwnFrame) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 1);
    for (int k = 0; k < 500; ++k) {
        const auto q =
            normalized(Quat<double>{normal(random), normal(random), normal(random), normal(random)});
        const Vec3<double> centre{normal(random), normal(random), normal(random)};
        const Vec3<double> local{3 * normal(random), 3 * normal(random), 3 * normal(random)};
        const Box own{{1, 2, 3}, {}, {}};
        Box turned = own;
        turned.position = {centre.x, centre.y, centre.z};
        turned.rotation = {q.x, q.y, q.z, q.w};
        const TangentPlane<double> expected = tangent(own, local);
        expectRow(turned, {centre + rotate(q, local), expected.distance, rotate(q, xyz(expected.plane))});
    }
}

/// 2 m about (1, 2, 3).
const Sphere kBall{2, {1, 2, 3}};
/// 1 m about a line of 4 m along (0.6, 0.8, 0).
const Capsule kRod{1, {1, 2, 3}, {1 + 2.4, 2 + 3.2, 3}};

TEST(Colliders, ASphereByItsCentre) {
    expectRow(kBall, {{1 + 3, 2, 3 + 4}, 3, {0.6, 0, 0.8}});
    expectRow(kBall, {{1, 2 - 2, 3}, 0, {0, -1, 0}});
    expectRow(kBall, {{1, 2, 3.5}, -1.5, {0, 0, 1}});
    expectRow(kBall, {{1 - 3e5, 2 + 4e5, 3}, 5e5 - 2, {-0.6, 0.8, 0}});
    expectRow(kBall, {{1, 2, 3}, -2, {0, 1, 0}});
}

TEST(Colliders, ACapsuleByItsLineAndItsEnds) {
    const Vec3<double> line{0.6, 0.8, 0}, across{-0.8, 0.6, 0}, from{1, 2, 3};
    for (const double along : {0.0, 1.5, 4.0}) {
        expectRow(kRod, {from + along * line + 3.0 * across, 2, across});
        expectRow(kRod, {from + along * line + Vec3<double>{0, 0, -0.25}, -0.75, {0, 0, -1}});
    }
    expectRow(kRod, {from + 4.5 * line, -0.5, line});
    expectRow(kRod, {from + 7.0 * line + 4.0 * across, 4, 0.6 * line + 0.8 * across});
    expectRow(kRod, {from + -3.0 * line, 2, -line});
}

/// In single precision a sphere as large as a hill is still exact to what a position is.
TEST(Colliders, SpheresInSinglePrecision) {
    const auto set =
        makeColliderSet<float>({Sphere{10, {0, -10, 0}}, Capsule{10, {0, -10, -1}, {0, -10, 1}}});
    for (uint32_t c = 0; c < 2; ++c)
        for (const float x : {0.0f, 0.5f, 3.0f}) {
            const TangentPlane<float> t = set.tangent(c, {x, 0.25f, 0});
            EXPECT_NEAR(double(t.distance), std::hypot(double(x), 10.25) - 10, 3e-6);
            EXPECT_NEAR(double(length(xyz(t.plane))), 1, 2e-7);
        }
}

/// The closed form once more, in other words: beyond the box its nearest point is the clamped one.
TEST(Colliders, OutsideTheNormalPointsFromTheNearestPoint) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-8, 12);
    int outside = 0;
    for (int k = 0; k < 500; ++k) {
        const Vec3<double> p{uniform(random), uniform(random), uniform(random)};
        const Vec3<double> nearest{std::clamp(p.x, 0.0, 2.0), std::clamp(p.y, 0.0, 4.0),
                                   std::clamp(p.z, 0.0, 6.0)};
        const Vec3<double> away = p - nearest;
        if (!(length2(away) > 0)) continue;
        ++outside;
        expectRow(kBox, {p, length(away), normalized(away)});
    }
    EXPECT_GT(outside, 300);
}

/// What predictions rely on: no point of the solid lies in front of a tangent plane.
TEST(Colliders, ASolidLiesBehindItsTangentPlanes) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(-8, 12);
    for (int k = 0; k < 500; ++k) {
        const TangentPlane<double> t = tangent(kBox, {uniform(random), uniform(random), uniform(random)});
        if (t.distance < 0) continue;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3<double> at{corner & 1 ? 2.0 : 0.0, corner & 2 ? 4.0 : 0.0, corner & 4 ? 6.0 : 0.0};
            EXPECT_LE(dot(xyz(t.plane), at) - t.plane.w, 1e-9);
        }
        const TangentPlane<double> rod = tangent(kRod, {uniform(random), uniform(random), uniform(random)});
        for (const Double3& end : {kRod.from, kRod.to})
            EXPECT_LE(dot(xyz(rod.plane), {end.x, end.y, end.z}) + kRod.radius - rod.plane.w, 1e-9);
    }
}

/// In single precision and with the low parts of positions; the normal to the last bit.
TEST(Colliders, AboveItsFacesABoxIsAPlane) {
    const auto faces = makeColliderSet<float>({Box{{2, 1, 2}, {0, -0.5, 0}, {}}, Plane{}});
    std::mt19937 random(3);
    std::uniform_real_distribution<float> aside(-0.9f, 0.9f), height(-0.01f, 0.3f), low(-1e-9f, 1e-9f);
    for (int k = 0; k < 500; ++k) {
        const Vec3<float> high{aside(random), height(random), aside(random)}, rest{0, low(random), 0};
        const TangentPlane<float> box = faces.tangent(0, high, rest), plane = faces.tangent(1, high, rest);
        EXPECT_NEAR(box.distance, plane.distance, 6e-8f) << "the box counts from its centre";
        EXPECT_EQ(box.plane.x, plane.plane.x);
        EXPECT_EQ(box.plane.y, plane.plane.y);
        EXPECT_EQ(box.plane.z, plane.plane.z);
    }
}

TEST(Colliders, TheLoopVisitsAllInTurn) {
    const auto set = makeColliderSet<double>({Plane{}, kBox, Plane{{1, 0, 0}, -2}});
    std::vector<double> seen;
    forEachCollider(set, Vec3<double>{3, 2, 3}, [&](uint32_t c, const TangentPlane<double>& t) {
        EXPECT_EQ(c, seen.size());
        seen.push_back(t.distance);
    });
    EXPECT_EQ(seen, (std::vector<double>{2, 1, 5}));
}

}  // namespace
}  // namespace demolish::tests
