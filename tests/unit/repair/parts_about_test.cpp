// SPDX-License-Identifier: Apache-2.0
// What one line tells of its points is what a ray tells of each.
#include <gtest/gtest.h>

#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/repair/parts_about.h"
#include "tests/unit/repair/open_meshes.h"

namespace demolish {
namespace {

using test::joined;
using test::makeSphere;
using test::turnedInsideOut;

/// x first, then y, then z; off the origin by `off` (m), 0.1 m apart.
std::vector<Double3> gridPoints(double off) {
    std::vector<Double3> points;
    for (int k = -12; k <= 12; ++k)
        for (int j = -12; j <= 12; ++j)
            for (int i = -12; i <= 12; ++i) points.push_back({0.1 * i + off, 0.1 * j + off, 0.1 * k + off});
    return points;
}

RepairMesh numbered(TriangleMesh mesh) {
    RepairMesh repair(std::move(mesh));
    numberParts(repair);
    return repair;
}

TEST(PartsAbout, LinesAndRaysTellTheSame) {
    TriangleMesh mesh = makeSphere(1, 3);
    mesh = joined(mesh, makeSphere(0.6, 3), {0.7, 0.1, 0});
    mesh = joined(mesh, turnedInsideOut(makeSphere(0.3, 2)), {-0.2, 0.05, 0.1});
    mesh = joined(mesh, makeSphere(0.4, 2), {0.5, 0.6, -0.3});
    const RepairMesh repair = numbered(mesh);
    ASSERT_EQ(repair.parts, 4u);
    PartsAbout parts(repair);
    const std::vector<Double3> points = gridPoints(0.0137);
    const auto of_lines = parts.eachOfGrid(points);
    EXPECT_EQ(of_lines, parts.each(points));
    size_t in_several = 0;
    for (const auto& about : of_lines) in_several += about.size() > 1;
    EXPECT_GT(in_several, 100u);
}

TEST(PartsAbout, ALineThatGrazesEdgesLeavesItsPointsToRays) {
    const RepairMesh repair =
        numbered(joined(test::makeBox({}, {1.6, 1.6, 1.6}), test::makeBox({0.3, 0.3, 0.3}, {1, 1, 1})));
    PartsAbout parts(repair);
    for (const auto& about : parts.eachOfGrid({{0, 0, 0}, {0.1, 0, 0}}))  // on the diagonals of the sides
        EXPECT_EQ(about, (std::vector<uint32_t>{0, 1}));
}

TEST(PartsAbout, NoPointsAreInNothing) {
    const RepairMesh repair = numbered(test::makeCube(1));
    PartsAbout parts(repair);
    EXPECT_TRUE(parts.eachOfGrid({}).empty());
    EXPECT_TRUE(parts.each({}).empty());
}

}  // namespace
}  // namespace demolish
