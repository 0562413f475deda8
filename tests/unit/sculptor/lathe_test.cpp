// SPDX-License-Identifier: Apache-2.0
// Turned bodies: exact counts, closed, and the shapes of the recipes.
#include "assets/models/lathe.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace demolish::sculptor {
namespace {

const Recipe kVase = readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/vase.toml");
const Recipe kColumn = readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/column.toml");

void expectClosed(const Turned& turned, std::size_t triangles) {
    const Topology topology = topologyOf(turned.surface);
    EXPECT_EQ(turned.surface.triangles.size(), triangles);
    EXPECT_EQ(turned.surface.positions.size(), triangles / 2 + 2);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 2);
    EXPECT_EQ(topology.parts, 1);
    ASSERT_EQ(turned.uvs.size(), triangles);
    for (const auto& triangle : turned.uvs)
        for (const auto& uv : triangle)
            for (const double coordinate : uv) {
                EXPECT_GE(coordinate, 0);
                EXPECT_LE(coordinate, 1 + 1e-12);
            }
}

TEST(Lathe, VaseHasTheRecipesCountsAndFinerOnes) {
    const auto& vase = std::get<VesselRecipe>(kVase.body);
    for (const std::size_t triangles : {3000u, 12200u, 19872u, 27600u})
        expectClosed(turnVessel(vase, triangles), triangles);
    EXPECT_THROW(turnVessel(vase, 3001), std::runtime_error);
    EXPECT_THROW(turnVessel(vase, 40), std::runtime_error);
}

TEST(Lathe, VaseIsThinWalledOutsideAndIn) {
    const Turned vase = turnVessel(std::get<VesselRecipe>(kVase.body), 12200);
    EXPECT_NEAR(volumeOf(vase.surface), 0.00595, 0.00025);
    double highest = 0, widest = 0;
    for (const Vec3 p : vase.surface.positions) {
        highest = std::max(highest, p.y);
        widest = std::max(widest, std::hypot(p.x, p.z));
    }
    EXPECT_NEAR(highest, 0.504, 1e-9);
    EXPECT_NEAR(widest, 0.174, 0.003);
    EXPECT_NEAR(vase.surface.positions.back().y, 0.036, 1e-12) << "inner bottom";
    const double outer_height = 0.38 * 0.5;
    double outer = 0, inner = 1;  // nearest ring to that height on both sides of the wall
    for (const Vec3 p : vase.surface.positions)
        if (std::abs(p.y - outer_height) < 0.012) {
            outer = std::max(outer, std::hypot(p.x, p.z));
            inner = std::min(inner, std::hypot(p.x, p.z));
        }
    EXPECT_NEAR(outer - inner, 0.014, 0.003);
}

TEST(Lathe, ColumnHasTheModelsCount) {
    const auto& column = std::get<ColumnRecipe>(kColumn.body);
    for (const std::size_t triangles : {672u, 674u, 720u, 1440u, 20160u})
        expectClosed(turnColumn(column, triangles), triangles);
    for (const std::size_t triangles : {670u, 673u, 722u, 20162u})
        EXPECT_THROW(turnColumn(column, triangles), std::runtime_error);
}

TEST(Lathe, ColumnHasSquareEndsAndTwelveFlutes) {
    const Turned column = turnColumn(std::get<ColumnRecipe>(kColumn.body), 674);
    EXPECT_NEAR(volumeOf(column.surface), 0.319, 0.0005);
    const auto& positions = column.surface.positions;
    const auto cornersAt = [&](double y, double half_side) {
        return std::count_if(positions.begin(), positions.end(), [&](Vec3 p) {
            return std::abs(p.y - y) < 1e-9 && std::abs(std::abs(p.x) - half_side) < 1e-9 &&
                   std::abs(std::abs(p.z) - half_side) < 1e-9;
        });
    };
    EXPECT_EQ(cornersAt(0.0, 0.3), 4);
    EXPECT_EQ(cornersAt(2.3, 0.26), 4);
    const auto drawn_in = std::count_if(positions.begin(), positions.end(), [](Vec3 p) {
        return std::abs(p.y - 1.1) < 1e-9 && std::hypot(p.x, p.z) < 0.9 * 0.205;
    });
    EXPECT_EQ(drawn_in, 12);
}

/// Smallest and largest distance from the axis among the vertices within 5 mm of a height.
std::pair<double, double> radiiAt(const Turned& turned, double y) {
    double least = 1e9, most = 0;
    for (const Vec3 p : turned.surface.positions) {
        if (std::abs(p.y - y) > 0.005) continue;
        least = std::min(least, std::hypot(p.x, p.z));
        most = std::max(most, std::hypot(p.x, p.z));
    }
    return {least, most};
}

TEST(Lathe, FineColumnKeepsTheOutlinesOfItsRings) {
    const Turned column = turnColumn(std::get<ColumnRecipe>(kColumn.body), 20160);
    // The shaft of the rings at 0.28 and 1.10 m, which swells a little over the straight line between them.
    const auto [flute, edge] = radiiAt(column, 1.10);
    EXPECT_NEAR(edge, 0.205, 0.0005);
    EXPECT_NEAR(flute, 0.86 * 0.205, 0.0005);
    const double halfway = radiiAt(column, 0.69).second;
    EXPECT_GT(halfway, 0.210);
    EXPECT_LT(halfway, 0.215);
    EXPECT_NEAR(radiiAt(column, 0.15).second, 0.300, 0.0005) << "torus";
    EXPECT_NEAR(radiiAt(column, 2.30).second, 0.26 * std::sqrt(2.0), 1e-9) << "corner of the abacus";
    EXPECT_NEAR(volumeOf(column.surface), 0.319, 0.003);
}

}  // namespace
}  // namespace demolish::sculptor
