// SPDX-License-Identifier: Apache-2.0
// Corners of cells: those of a box are all there, of many the ones that matter, and no cell reaches far
// beyond its own.
#include "sim_cuda/authoring/cell_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

TEST(CellCorners, OfABoxAreItsEightAndNothingInside) {
    std::vector<Double3> points{{0, 0, 0}, {0.1, 0.2, -0.1}};
    for (int k = 0; k < 8; ++k)
        points.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 2.0 : -2.0, k & 4 ? 0.5 : -0.5});
    const auto corners = hullCorners(points, 1e-9);
    EXPECT_EQ(corners.size(), 8u);
    for (const Double3& corner : corners) EXPECT_EQ(std::abs(corner.x), 1.0);
    EXPECT_TRUE(hullCorners({}, 1e-9).empty());
}

TEST(CellCorners, OfAManySidedBodyAreFewAndLeaveOutLittle) {
    std::vector<Double3> points;
    for (int k = 0; k < 60; ++k) {
        const double z = 1 - (2 * k + 1.0) / 60, r = std::sqrt(1 - z * z), a = 2.39996 * k;
        points.push_back({r * std::cos(a), r * std::sin(a), z});
    }
    const auto corners = hullCorners(points, 1e-9);
    EXPECT_EQ(corners.size(), kMostCorners);
    for (const Double3& p : points) {
        double reach = -1;
        for (const Double3& corner : corners) reach = std::max(reach, dot(corner, p));
        EXPECT_GT(reach, 0.7);
    }
}

/// Nothing of a packed body lies lower than its lowest corner, and corners lie on the surface or inside.
TEST(CellCorners, HoldABodyAsItIsDrawn) {
    const auto body = fillWithParticles(SolidMesh(makeCube(1)), {.particles = 100, .seed = 3});
    ASSERT_EQ(body->corners.start.size(), body->particles.size() + 1);
    double lowest = 1e300, highest = -1e300, missed = 0;
    for (size_t i = 0; i < body->particles.size(); ++i) {
        const uint32_t first = body->corners.start[i], last = body->corners.start[i + 1];
        EXPECT_GE(last - first, 4u);
        EXPECT_LE(last - first, kMostCorners);
        double low = 1e300;
        for (uint32_t c = first; c < last; ++c) {
            const Double3 at = body->particles[i].seed + body->corners.from_seed[c];
            EXPECT_LT(std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}), 0.5 + 1e-9);
            low = std::min(low, at.y);
            highest = std::max(highest, at.y);
        }
        EXPECT_NEAR(low, body->particles[i].lowest, 0.15 * body->spacing);
        missed += low - body->particles[i].lowest;
        lowest = std::min(lowest, low);
    }
    EXPECT_LT(missed / double(body->particles.size()), 0.02 * body->spacing);
    EXPECT_NEAR(lowest, -0.5, 1e-9);
    EXPECT_NEAR(highest, 0.5, 1e-9);
}

}  // namespace
}  // namespace demolish::test
