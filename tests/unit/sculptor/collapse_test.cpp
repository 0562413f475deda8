// SPDX-License-Identifier: Apache-2.0
// Edge collapse: exact counts, manifold, genus kept, shape kept.
#include "assets/models/collapse.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "assets/models/editable_mesh.h"
#include "assets/models/marching.h"
#include "assets/models/quadric.h"
#include "assets/models/relax.h"

namespace demolish::sculptor {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Unit ball, marched and relaxed as in the pipeline.
Surface roundBall() {
    constexpr double kCell = 0.0813;
    FieldRecipe recipe;
    recipe.parts.emplace_back();
    recipe.parts.back().radii = {1, 1, 1};
    const Field field(recipe);
    Surface ball = marchTetrahedra([&](Vec3 p) { return field.at(p); }, field.bounds(), kCell);
    relax(ball, field, kCell, 6);
    return ball;
}

/// Torus around y, radius 1, tube 0.35, of even triangles.
Surface ring() {
    constexpr std::uint32_t kAround = 72, kTube = 26;
    Surface surface;
    for (std::uint32_t i = 0; i < kAround; ++i)
        for (std::uint32_t j = 0; j < kTube; ++j) {
            const double around = 2 * kPi * i / kAround, tube = 2 * kPi * j / kTube;
            const double r = 1 + 0.35 * std::cos(tube);
            surface.positions.push_back({r * std::cos(around), 0.35 * std::sin(tube), r * std::sin(around)});
            const std::uint32_t next = (i + 1) % kAround * kTube, up = (j + 1) % kTube;
            surface.triangles.push_back({i * kTube + j, i * kTube + up, next + up});
            surface.triangles.push_back({i * kTube + j, next + up, next + j});
        }
    return surface;
}

Surface tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

double evenly(Vec3) {
    return 1;
}

TEST(Collapse, HitsTheCountAndStaysManifold) {
    const Surface ball = roundBall();
    for (const std::size_t target : {2000u, 592u, 100u, 20u}) {
        const Surface small = collapseTo(ball, target, evenly);
        const Topology topology = topologyOf(small);
        EXPECT_EQ(small.triangles.size(), target);
        EXPECT_EQ(small.positions.size(), target / 2 + 2);
        EXPECT_TRUE(topology.closed);
        EXPECT_EQ(topology.euler, 2);
    }
}

TEST(Collapse, KeepsTheHandleOfATorus) {
    const Surface small = collapseTo(ring(), 300, evenly);
    const Topology topology = topologyOf(small);
    EXPECT_EQ(small.triangles.size(), 300u);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 0);
    EXPECT_NEAR(volumeOf(small), 2 * kPi * kPi * 0.35 * 0.35, 0.12);
}

TEST(Collapse, StaysCloseToTheSurface) {
    const Surface small = collapseTo(roundBall(), 400, evenly);
    for (const Vec3 p : small.positions) EXPECT_NEAR(length(p), 1, 0.03);
    EXPECT_NEAR(volumeOf(small), 4.0 / 3 * kPi, 0.08);
    for (const Triangle& t : small.triangles) {
        const Vec3 centre =
            (1.0 / 3) * (small.positions[t[0]] + small.positions[t[1]] + small.positions[t[2]]);
        EXPECT_GT(dot(normalized(areaNormal(small, t)), normalized(centre)), 0.8) << "no folded triangle";
    }
}

TEST(Collapse, SpendsTrianglesWhereTheWeightIs) {
    const Surface small = collapseTo(roundBall(), 300, [](Vec3 p) { return p.y > 0 ? 10.0 : 1.0; });
    const auto above =
        std::count_if(small.positions.begin(), small.positions.end(), [](Vec3 p) { return p.y > 0; });
    EXPECT_GT(above, 95) << "of 152";
}

TEST(Collapse, RefusesWhatCannotBe) {
    EXPECT_THROW(collapseTo(roundBall(), 591, evenly), std::runtime_error);
    EXPECT_THROW(collapseTo(roundBall(), 2, evenly), std::runtime_error);
    EXPECT_THROW(collapseTo(tetrahedron(), 6, evenly), std::runtime_error);
    EXPECT_THROW(collapseTo(ring(), 4, evenly), std::runtime_error)
        << "a torus needs more than a tetrahedron";
}

TEST(EditableMesh, LinkConditionGuardsTheLastTetrahedron) {
    const EditableMesh mesh(tetrahedron());
    EXPECT_EQ(mesh.neighbours(0), (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_FALSE(mesh.keepsManifold(0, 1));
}

TEST(EditableMesh, LinkConditionForbidsClosingANeck) {
    // A prism of three sides, its waist at vertices 3..5: collapsing a waist edge would pinch the surface.
    Surface prism;
    for (const double y : {0.0, 1.0, 2.0})
        for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}})
            prism.positions.push_back({p.x, y, p.z});
    prism.triangles = {{0, 2, 1}, {6, 7, 8}};
    for (std::uint32_t level = 0; level < 6; level += 3)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t a = level + i, b = level + (i + 1) % 3;
            prism.triangles.push_back({a, b, b + 3});
            prism.triangles.push_back({a, b + 3, a + 3});
        }
    ASSERT_TRUE(topologyOf(prism).closed);
    ASSERT_EQ(topologyOf(prism).euler, 2);
    EXPECT_FALSE(EditableMesh(prism).keepsManifold(3, 4));
    EXPECT_TRUE(EditableMesh(prism).keepsManifold(0, 3));
}

TEST(EditableMesh, ShapeTestSeesAFlip) {
    const Surface ball = collapseTo(roundBall(), 200, evenly);
    const EditableMesh mesh(ball);
    const std::uint32_t a = 0, b = mesh.neighbours(0).front();
    const Vec3 between = 0.5 * (mesh.position(a) + mesh.position(b));
    EXPECT_TRUE(mesh.keepsShape(a, b, between, {0.0, 0.0}));
    EXPECT_FALSE(mesh.keepsShape(a, b, -1.0 * between, {0.0, 0.0}));
}

TEST(Quadric, MinimumOfThreePlanesIsTheirCorner) {
    const Vec3 corner{1, 2, 3};
    const Quadric sum = Quadric::plane({1, 0, 0}, corner, 2) + Quadric::plane({0, 1, 0}, corner, 1) +
                        Quadric::plane({0, 0, 1}, corner, 3);
    EXPECT_NEAR(sum.at(corner), 0, 1e-12);
    EXPECT_NEAR(sum.at({2, 2, 3}), 2, 1e-12);
    EXPECT_NEAR(length(sum.minimum({1.5, 2.5, 2.5}) - corner), 0, 5e-3);
    const Vec3 on_plane = Quadric::plane({0, 1, 0}, corner, 1).minimum({7, 2, 9});
    EXPECT_NEAR(length(on_plane - Vec3{7, 2, 9}), 0, 1e-12) << "a flat place leaves the guess where it is";
}

}  // namespace
}  // namespace demolish::sculptor
