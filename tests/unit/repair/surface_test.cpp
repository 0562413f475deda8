// SPDX-License-Identifier: Apache-2.0
// Winding numbers, new surfaces, unions: against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/repair/remesh.h"
#include "sim_cuda/authoring/repair/unite.h"
#include "sim_cuda/authoring/repair/winding_number.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "tests/unit/repair/open_meshes.h"

namespace demolish {
namespace {

using test::joined;
using test::makeBox;
using test::makeCube;

TEST(WindingNumber, OneInsideNoneOutsideAndTheSolidAngleOverHoles) {
    const WindingNumber closed(test::makeSphere(1, 3));
    EXPECT_NEAR(closed.at({0.1, 0.2, -0.3}), 1, 0.02);
    EXPECT_NEAR(closed.at({1.3, 0.2, -0.3}), 0, 0.01);
    EXPECT_NEAR(closed.at({0, 0, 40}), 0, 0.01);
    // a cube without a lid, from its middle: five of six sides
    TriangleMesh cube = makeCube(1);
    EXPECT_NEAR(WindingNumber(test::without(cube, {0, 1})).at({}), 5.0 / 6, 1e-9);
    std::vector<char> flags(12, 1);
    flags[0] = flags[1] = 0;
    EXPECT_NEAR(WindingNumber(cube, flags).at({}), 5.0 / 6, 1e-9);
    EXPECT_EQ(WindingNumber(TriangleMesh{}).at({}), 0);
}

/// Of triangles so large that none is far: each taken on its own, by the formula of Van Oosterom and
/// Strackee.
TEST(WindingNumber, APileOfTrianglesIsTheSumOfTheirSolidAngles) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1, 1);
    const auto anywhere = [&] { return Double3{place(random), place(random), place(random)}; };
    TriangleMesh pile = makeCube(2);
    const size_t shell = pile.triangles.size();
    for (uint32_t copies = 1; copies < 30; ++copies)  // wound thirty times
        for (size_t t = 0; t < shell; ++t) pile.triangles.push_back(pile.triangles[t]);
    for (int k = 0; k < 400; ++k) {
        const auto first = uint32_t(pile.positions.size());
        for (int corner = 0; corner < 3; ++corner) pile.positions.push_back(anywhere());
        pile.triangles.push_back({first, first + 1, first + 2});
    }
    const WindingNumber winding(pile);
    for (int k = 0; k < 200; ++k) {
        const Double3 p = anywhere() * 0.2;
        double halves = 0;
        for (const auto& t : pile.triangles) {
            const Double3 a = pile.positions[t[0]] - p, b = pile.positions[t[1]] - p,
                          c = pile.positions[t[2]] - p;
            const double la = length(a), lb = length(b), lc = length(c);
            halves += std::atan2(dot(a, cross(b, c)),
                                 la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
        }
        EXPECT_NEAR(winding.at(p), halves / (2 * std::numbers::pi), 1e-9);
        EXPECT_GT(winding.at(p), 20);
    }
}

/// Farthest vertex of the surface from the original, m.
double offOf(const TriangleMesh& surface, const TriangleMesh& original) {
    const MeshQueries queries(original);
    double off = 0;
    for (const Double3& p : surface.positions) off = std::max(off, queries.closestPoint(p).distance);
    return off;
}

TEST(Remesh, ClosedFormsOfBoxesSpheresAndTori) {
    const double r = 1, tube = 0.3;
    const struct {
        TriangleMesh mesh;
        double tolerance;
    } cases[] = {
        {makeCube(1), 1e-3}, {test::makeSphere(r, 4), 1e-3}, {test::makeTorus(r, tube, 64, 32), 3e-3}};
    for (const auto& [mesh, tolerance] : cases) {
        const RepairMesh surface = remeshed(RepairMesh(mesh), true);
        EXPECT_TRUE(isSolid(surface.mesh));
        EXPECT_NEAR(enclosedVolume(surface.mesh) / enclosedVolume(mesh), 1, tolerance);
        const double cell = diagonalOf(mesh) / kRemeshCells;
        EXPECT_LT(offOf(surface.mesh, mesh), 0.15 * cell);
        EXPECT_LT(offOf(mesh, surface.mesh), 0.3 * cell) << "nothing of the file's is left out";
        constexpr double kParticles = 10000;  // a fifth of the spacing that they have in this body
        EXPECT_LT(0.3 * cell, 0.2 * std::cbrt(enclosedVolume(mesh) / kParticles));
    }
}

TEST(Remesh, OpenMeshesCloseOverTheirHoles) {
    for (const TriangleMesh& mesh :
         {test::without(test::makeSphere(1, 3), {5, 6}), test::unwelded(makeCube(1))}) {
        const RepairMesh surface = remeshed(RepairMesh(mesh), false);
        EXPECT_TRUE(isSolid(surface.mesh));
        EXPECT_NEAR(enclosedVolume(surface.mesh) / std::abs(enclosedVolume(mesh)), 1, 0.02);
    }
}

TEST(Remesh, LooksAndNumbersComeFromTheTriangleNearest) {
    TriangleMesh cube = makeCube(1);
    for (size_t t = 0; t < cube.triangles.size(); ++t)  // each its own chart: u is what y is
        for (size_t k = 0; k < 3; ++k) {
            const Double3& p = cube.positions[cube.triangles[t][k]];
            cube.corners[t][k].uv = {float(p.y + 10 * double(t)), float(t)};
            cube.corners[t][k].second_uv = {float(t), float(2 * p.y - 10 * double(t))};
        }
    const RepairMesh surface = remeshed(RepairMesh(cube), true);
    const MeshQueries queries(cube);
    for (size_t t = 0; t < surface.size(); ++t) {
        const uint32_t source = surface.source[t];
        ASSERT_LT(source, 12u);
        for (int k = 0; k < 3; ++k) {
            const CornerAttributes& corner = surface.mesh.corners[t][size_t(k)];
            EXPECT_NEAR(corner.uv.y, float(source), 1e-3);  // no smear between charts
            EXPECT_NEAR(corner.second_uv.x, float(source), 1e-3);
            const Double3 normal = RepairMesh(cube).normal(source);
            if (std::abs(normal.y) < 0.5) {
                EXPECT_NEAR(corner.uv.x, surface.at(t, k).y + 10.0 * source, 1e-3);
                EXPECT_NEAR(corner.second_uv.y, 2 * surface.at(t, k).y - 10.0 * source, 2e-3);
            }
        }
    }
}

/// United as the repair does it, checked for closedness.
RepairMesh unitedOf(TriangleMesh mesh, size_t parts_expected) {
    RepairMesh repair(std::move(mesh));
    numberParts(repair);
    const WindingSamples samples = sampleWinding(repair.mesh);
    EXPECT_EQ(uniteParts(repair, samples), parts_expected);
    EXPECT_TRUE(isSolid(repair.mesh));
    EXPECT_LT(sampleWinding(repair.mesh).overlap(), 1e-3);
    return repair;
}

TEST(Unite, CrossingBars) {
    const TriangleMesh bars = joined(makeBox({}, {2, 0.6, 0.6}), makeBox({}, {0.6, 0.6, 2}));
    EXPECT_NEAR(enclosedVolume(unitedOf(bars, 2).mesh), 2 * 0.72 - 0.216, 0.002);
}

TEST(Unite, SpheresThatOverlapInALens) {
    const double r = 1, d = 1.2;
    const TriangleMesh two = joined(test::makeSphere(r, 4), test::makeSphere(r, 4), {d, 0, 0});
    const double lens = std::numbers::pi * (4 * r + d) * (2 * r - d) * (2 * r - d) / 12;
    const double sphere = enclosedVolume(test::makeSphere(r, 4));
    EXPECT_NEAR(enclosedVolume(unitedOf(two, 2).mesh) / (2 * sphere - lens), 1, 0.005);
}

TEST(Unite, APartWithinAnotherGoes) {
    EXPECT_NEAR(enclosedVolume(unitedOf(joined(makeCube(2), test::makeSphere(0.7, 3)), 2).mesh), 8, 0.01);
}

TEST(Unite, HollowsOfTheirHostsStay) {
    TriangleMesh host = joined(makeCube(2), test::turnedInsideOut(makeCube(1)));
    host = joined(host, makeBox({1, 0, 0}, {0.5, 0.5, 0.5}));
    EXPECT_NEAR(enclosedVolume(unitedOf(host, 3).mesh), 8 - 1 + 0.5 * 0.5 * 0.25, 0.02);
}

TEST(Unite, WhatOverlapsNothingStaysAsItWas) {
    const TriangleMesh bars = joined(makeBox({}, {2, 0.6, 0.6}), makeBox({}, {0.6, 0.6, 2}));
    const TriangleMesh apart = test::makeSphere(0.5, 2);
    const RepairMesh repair = unitedOf(joined(apart, bars, {4, 0, 0}), 2);
    for (size_t v = 0; v < apart.positions.size(); ++v)
        EXPECT_EQ(length(repair.mesh.positions[v] - apart.positions[v]), 0);
    for (size_t t = 0; t < apart.triangles.size(); ++t) EXPECT_EQ(repair.source[t], t);
}

TEST(Unite, ManyPairsShareOneSurface) {
    TriangleMesh pairs;
    for (int i = 0; i < 20; ++i) {
        const Double3 place{2.0 * (i % 5), 0, 2.0 * (i / 5)};
        pairs = test::joined(pairs, test::joined(makeBox(place, {1, 1, 1}), makeBox(place, {0.5, 2, 0.5})));
    }
    EXPECT_NEAR(enclosedVolume(unitedOf(pairs, 40).mesh) / (20 * 1.25), 1, 0.02);
}

TEST(WindingSamples, TellOverlapAndInsideOut) {
    const WindingSamples nested = sampleWinding(joined(makeCube(2), makeCube(1)));
    EXPECT_NEAR(nested.overlap(), 1.0 / 8, 0.01);
    EXPECT_NEAR(nested.volume, 8, 1e-9);
    EXPECT_FALSE(nested.isInsideOut());
    EXPECT_TRUE(
        sampleWinding(joined(makeCube(2), test::turnedInsideOut(makeCube(1)), {3, 0, 0})).isInsideOut());
}

TEST(WindingSamples, DifferFromTheFilesOwnByItsCaps) {
    const TriangleMesh sphere = test::makeSphere(1, 3);
    EXPECT_EQ(windingDifference(sphere, {}), 0) << "nothing was capped";
    EXPECT_NEAR(windingDifference(sphere, sphere), 1, 0.01) << "nothing but caps";
    const RepairMesh repair(sphere);
    std::set<size_t> above, below;
    for (size_t t = 0; t < repair.size(); ++t) (repair.middle(t).y > 0.2 ? above : below).insert(t);
    // By the definition: the file's triangles summed up.
    const WindingNumber dish(test::without(sphere, above));
    constexpr int kAlong = 24;
    size_t inside = 0, different = 0;
    for (int i = 0; i < kAlong * kAlong * kAlong; ++i) {
        const auto at = [](int k) { return 2 * (k + 0.513) / kAlong - 1; };
        const Double3 p{at(i % kAlong), at(i / kAlong % kAlong), at(i / kAlong / kAlong)};
        const bool is_inside = length(p) < 1;
        inside += is_inside;
        different += is_inside != (dish.at(p) > 0.5);
    }
    EXPECT_GT(different, inside / 5);
    EXPECT_NEAR(windingDifference(sphere, test::without(sphere, below)), double(different) / double(inside),
                0.02);
}

}  // namespace
}  // namespace demolish
