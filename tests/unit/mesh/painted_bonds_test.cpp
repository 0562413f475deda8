// SPDX-License-Identifier: Apache-2.0
// What is painted at the vertices of a model becomes the strength of its bonds.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/painted_bonds.h"
#include "sim_cuda/physics/painted_strength.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

/// A cube of 1 m on y = 0 whose `channel` runs from 0 at x = -0.5 to 255 at x = 0.5; the others are `rest`.
TriangleMesh paintedCube(int channel, uint32_t rest) {
    TriangleMesh mesh = test::makeCube(1);
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const bool bright = mesh.positions[mesh.triangles[t][k]].x > 0;
            const uint32_t mask = 0xffu << 8 * channel;
            mesh.corners[t][k].colour = (rest & ~mask) | (bright ? mask : 0);
        }
    return mesh;
}

BondGeometry bondOf(uint32_t i, uint32_t j) {
    BondGeometry bond{};
    bond.i = i;
    bond.j = j;
    return bond;
}

TEST(PaintedBonds, FollowTheLawFromBlackToWhite) {
    EXPECT_EQ(paintedStrength(1, 0.1), 1);
    EXPECT_EQ(paintedStrength(0, 0.1), 0.1);
    EXPECT_NEAR(paintedStrength(0.5, 0.2), 0.6, 1e-12);
}

TEST(PaintedBonds, TakeTheLeastValueOfTheNearestOutsideAlongTheirWay) {
    // Near the side z = 0.5, where the colour runs with x.
    const std::vector<Double3> seeds{{-0.3, 0, 0.45}, {0.1, 0, 0.45}, {0.1, 0.2, 0.45}};
    const std::vector<BondGeometry> bonds{bondOf(0, 1), bondOf(1, 2)};
    for (int channel = 0; channel < 4; ++channel) {
        const TriangleMesh mesh = paintedCube(channel, 0xffffffffu);
        const MeshQueries queries(mesh);
        const auto factors =
            paintedBonds(mesh, queries, seeds, bonds, {static_cast<PaintChannel>(channel), 0.1});
        EXPECT_NEAR(factors[0], 0.1 + 0.9 * 0.2, 1e-9) << channel;
        EXPECT_NEAR(factors[1], 0.1 + 0.9 * 0.6, 1e-9) << channel;
        const auto other =
            paintedBonds(mesh, queries, seeds, bonds, {static_cast<PaintChannel>((channel + 1) % 4), 0.1});
        EXPECT_EQ(other[0], 1) << "white in the next channel";
    }
}

TEST(PaintedBonds, AreMadeWhereTheyAreAskedFor) {
    auto looks = std::make_shared<ModelLooks>();
    looks->has_colours = true;
    const auto solid = makeSolidMesh(paintedCube(0, 0xffffffffu), "cube.ply", {}, looks);
    FillOptions options{.particles = 200};
    EXPECT_TRUE(fillWithParticles(*solid, options)->bond_strength.empty());
    options.painted = PaintedStrength{PaintChannel::kRed, 0.25};
    const auto body = fillWithParticles(*solid, options);
    ASSERT_EQ(body->bond_strength.size(), body->bonds.size());
    size_t weak = 0, strong = 0;
    for (const double factor : body->bond_strength) {
        EXPECT_GE(factor, 0.25);
        EXPECT_LE(factor, 1);
        weak += factor < 0.5;
        strong += factor > 0.8;
    }
    EXPECT_GT(weak, body->bonds.size() / 10);
    EXPECT_GT(strong, body->bonds.size() / 10);
}

}  // namespace
}  // namespace demolish
