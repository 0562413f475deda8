// SPDX-License-Identifier: Apache-2.0
// The distance grid of a mesh against the closed forms of the sphere and the box that it is of.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/kernels/press_on_shape.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::tests {
namespace {

std::shared_ptr<const ColliderMesh> gridOf(TriangleMesh mesh, uint32_t cells = 96) {
    return makeColliderMesh(std::move(mesh), "test.obj", {.repair = {}, .cells = cells});
}
std::shared_ptr<const ColliderMesh> ballOfTriangles() {
    static const auto mesh = gridOf(test::makeSphere(1, 5));
    return mesh;
}
std::shared_ptr<const ColliderMesh> cubeOfTriangles() {
    static const auto mesh = gridOf(test::makeCube(1));
    return mesh;
}

TangentPlane<double> tangent(const Collider& collider, const Vec3<double>& point) {
    return makeColliderSet<double>({collider}).tangent(0, point);
}

class Points {
  public:
    explicit Points(double reach) : uniform_(-reach, reach) {}
    Vec3<double> next() { return {uniform_(random_), uniform_(random_), uniform_(random_)}; }

  private:
    std::mt19937 random_{11};
    std::uniform_real_distribution<double> uniform_;
};

TEST(MeshCollider, ASphereOfTrianglesIsTheSphere) {
    const MeshShape mesh{ballOfTriangles(), 1, {}, {}};
    Points points(1.4);
    int near = 0;
    for (int k = 0; k < 4000; ++k) {
        const Vec3<double> p = points.next();
        if (length(p) < 0.3) continue;  // towards the middle all sides are as near
        const TangentPlane<double> found = tangent(mesh, p), expected = tangent(Sphere{1, {}}, p);
        EXPECT_NEAR(found.distance, expected.distance, 0.01) << "far from the surface it is an estimate";
        EXPECT_GT(dot(xyz(found.plane), xyz(expected.plane)), 0.99);
        EXPECT_NEAR(length(xyz(found.plane)), 1, 1e-6);
        if (std::abs(expected.distance) > 0.02) continue;
        ++near;
        EXPECT_NEAR(found.distance, expected.distance, 5e-4);
        EXPECT_GT(dot(xyz(found.plane), xyz(expected.plane)), 0.9995);
    }
    EXPECT_GT(near, 50);
}

/// Loops see the box first, and look closer only where it may be touched.
TEST(MeshCollider, ItsBoxNeverSaysMoreThanTheDistance) {
    const MeshShape ring{
        gridOf(test::makeTorus(0.5, 0.1, 32, 16)), 1, {0.1, 0, 0}, {0.1, 0.2, 0.3, 0.92736185}};
    const auto set = makeColliderSet<double>({ring});
    Points points(0.9);
    int told = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec3<double> p = points.next();
        const double distance = set.tangent(0, p).distance, box = set.bound(0, p).distance;
        EXPECT_LE(box, distance + 1e-9);
        told += box > 0.1;
    }
    EXPECT_GT(told, 2000);
}

/// At places along its grid, within it and beyond.
template <class Real>
void expectSameDistances(const MeshShape& ring) {
    const ColliderRows<Real> rows = makeColliderSet<Real>({ring}).collider[0];
    Points points(1);
    int told = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec3<double> p = points.next();
        const auto along = [](double x, uint32_t nodes) { return Real(0.5 * (1.2 * x + 1) * nodes); };
        const Vec3<Real> at{along(p.x, rows.counts & 1023), along(p.y, rows.counts >> 10 & 1023),
                            along(p.z, rows.counts >> 20)};
        const CornersOnMesh<Real> corners{rows};
        const GridPlace<Real> place = gridPlace(rows, at);
        const Real first = corners.unit() * corners.firstLook(at),
                   distance = awayFromMesh(rows, place).distance;
        ASSERT_EQ(first, corners.unit() * corners.away(at).distance);
        const bool beyond = length2(Vec3<Real>{place.x.beyond, place.y.beyond, place.z.beyond}) > Real(0);
        if (beyond)
            ASSERT_TRUE(first > Real(0) && first < Real(1.1) * distance) << first << " of " << distance;
        else
            ASSERT_EQ(first, distance);
        told += beyond ? 0 : 1;
    }
    EXPECT_GT(told, 5000);
    EXPECT_LT(told, 19000) << "none lies beyond the grid";
}
TEST(MeshCollider, TheFirstLookTellsTheDistanceToTheLastBitAndBeyondTheGridNoMore) {
    const MeshShape ring{
        gridOf(test::makeTorus(0.5, 0.1, 32, 16)), 1, {0.1, 0, 0}, {0.1, 0.2, 0.3, 0.92736185}};
    expectSameDistances<double>(ring);
    expectSameDistances<float>(ring);
}

/// What is far from the surface need not be looked at any closer, and no touch may be missed by that.
TEST(MeshCollider, OneNodeNeverTellsMoreThanTheDistance) {
    const MeshShape ring{
        gridOf(test::makeTorus(0.5, 0.1, 32, 16)), 1, {0.1, 0, 0}, {0.1, 0.2, 0.3, 0.92736185}};
    const auto set = makeColliderSet<float>({ring});
    const ColliderRows<float>& rows = set.collider[0];
    Points points(0.7);
    int told = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec3<double> p = points.next();
        const Vec3<float> high{float(p.x), float(p.y), float(p.z)}, low{};
        const float distance = set.tangent(0, high).distance, least = leastDistance<float>(rows, high, low);
        ASSERT_LE(least, std::max(distance, 0.0f));
        if (set.bound(0, high).distance > rows.margin / 2) continue;
        ASSERT_GT(least, distance - (kNodesDiffer + 2) * stepOf(rows.row[3]));
        told += least > 0.05f;
    }
    EXPECT_GT(told, 500);
}

/// Distances of its faces are linear, and interpolation keeps them; its edges are rounded by less than a
/// cell.
TEST(MeshCollider, ABoxOfTrianglesIsTheBox) {
    const MeshShape mesh{cubeOfTriangles(), 1, {}, {}};
    const Box box{{1, 1, 1}, {}, {}};
    const double cell = 1.0 / 96;
    Points points(0.62);
    for (int k = 0; k < 4000; ++k) {
        const Vec3<double> p = points.next();
        const TangentPlane<double> found = tangent(mesh, p), expected = tangent(box, p);
        EXPECT_NEAR(found.distance, expected.distance, 0.87 * cell);
        const double sides[]{std::abs(p.x), std::abs(p.y), std::abs(p.z)};
        const int on_side = (sides[0] > 0.4) + (sides[1] > 0.4) + (sides[2] > 0.4);
        if (on_side != 1 || expected.distance < -0.05) continue;
        EXPECT_NEAR(found.distance, expected.distance, 1e-6);
        EXPECT_NEAR(dot(xyz(found.plane), xyz(expected.plane)), 1, 1e-6);
    }
}

/// From beyond the grid the nearest place of the surface is that which its rim sees.
TEST(MeshCollider, FarAwayTheDistanceGoesOn) {
    const MeshShape mesh{ballOfTriangles(), 1, {}, {}};
    Points points(8);
    for (int k = 0; k < 2000; ++k) {
        const Vec3<double> p = points.next();
        if (length(p) < 1.5) continue;
        const TangentPlane<double> found = tangent(mesh, p);
        EXPECT_GT(found.distance, length(p) - 1.001);
        EXPECT_LT(found.distance, 1.08 * (length(p) - 1));
        EXPECT_GT(dot(xyz(found.plane), normalized(p)), 0.98);
    }
}

TEST(MeshCollider, PlacedTurnedAndScaledItIsTheSame) {
    const auto q = normalized(Quat<double>{0.3, -0.2, 0.5, 0.7});
    const MeshShape own{cubeOfTriangles(), 1, {}, {}};
    const MeshShape placed{cubeOfTriangles(), 2.5, {3, -1, 7}, {q.x, q.y, q.z, q.w}};
    Points points(0.7);
    for (int k = 0; k < 500; ++k) {
        const Vec3<double> p = points.next(), at = Vec3<double>{3, -1, 7} + 2.5 * rotate(q, p);
        const TangentPlane<double> expected = tangent(own, p), found = tangent(placed, at);
        EXPECT_NEAR(found.distance, 2.5 * expected.distance, 1e-9);
        EXPECT_NEAR(dot(xyz(found.plane), rotate(q, xyz(expected.plane))), 1, 1e-9);
        EXPECT_NEAR(dot(xyz(found.plane), at) - found.plane.w, found.distance, 1e-9);
    }
}

TEST(MeshCollider, InSinglePrecisionItIsTheSame) {
    const std::vector<Collider> colliders{MeshShape{ballOfTriangles(), 1, {0.3, 0.2, 0.1}, {}}};
    const auto fine = makeColliderSet<double>(colliders);
    const auto plain = makeColliderSet<float>(colliders);
    Points points(1.3);
    for (int k = 0; k < 1000; ++k) {
        const Vec3<double> p = points.next();
        const Vec3<float> point{float(p.x), float(p.y), float(p.z)};
        EXPECT_NEAR(plain.tangent(0, point).distance, fine.tangent(0, {point.x, point.y, point.z}).distance,
                    3e-6);
    }
}

/// What predictions rely on.
TEST(MeshCollider, NothingComesNearerThanItsApproachSays) {
    const auto set =
        makeColliderSet<double>({MeshShape{gridOf(test::makeTorus(1, 0.3, 24, 12), 48), 1, {}, {}}});
    Points places(2), ways(3);
    for (int k = 0; k < 3000; ++k) {
        const Vec3<double> from = places.next(), velocity = ways.next();
        const Approach<double> way = set.approach(0, from, velocity);
        EXPECT_LE(set.bound(0, from).distance, set.tangent(0, from).distance + 1e-9);
        for (const double time : {0.01, 0.1, 0.4}) {
            const double then = set.tangent(0, axpy(time, velocity, from)).distance;
            if (then > 0) continue;
            EXPECT_LE(way.distance - std::max(way.speed, 0.0) * time, 1e-6) << "it has come inside";
        }
    }
}

TEST(MeshCollider, TheGridDoesNotDependOnThreads) {
    const auto stepsWith = [](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return gridOf(test::makeTorus(1, 0.3, 24, 12), 48)->nodes.steps;
    };
    EXPECT_EQ(stepsWith(1), stepsWith(2));
}

std::string refusalOf(TriangleMesh mesh, const ColliderMeshOptions& options) {
    try {
        makeColliderMesh(std::move(mesh), "test.obj", options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(MeshCollider, WhatCannotBeAGridIsRefusedWithASentence) {
    TriangleMesh open = test::makeCube(1);
    open.triangles.pop_back();
    open.corners.pop_back();
    EXPECT_NE(refusalOf(open, {.repair = {RepairMode::kOff, 0}, .cells = 16}).find("test.obj"),
              std::string::npos);
    EXPECT_EQ(refusalOf(open, {.repair = {}, .cells = 16}), "") << "repair closes it";
    EXPECT_NE(refusalOf({}, {}).find("no triangles"), std::string::npos);
    EXPECT_NE(refusalOf(test::makeCube(1), {.repair = {}, .cells = 4}).find("from 8 to 800"),
              std::string::npos);
    const std::string too_many = refusalOf(test::makeCube(1), {.repair = {}, .cells = 800});
    EXPECT_NE(too_many.find("at most 67108864 are possible; choose 33"), std::string::npos) << too_many;
}

}  // namespace
}  // namespace demolish::tests
