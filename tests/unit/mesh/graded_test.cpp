// SPDX-License-Identifier: Apache-2.0
// Graded sizes: as many cells as asked for, sizes that follow the field, the same body.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "sim_cuda/authoring/struck_place.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

const ShotAim kFromTheRight{.way = {-1, 0, 0}, .height = 0};

std::shared_ptr<const BreakableBody> filled(const TriangleMesh& mesh, uint32_t particles, double refine,
                                            bool conform = false) {
    FillOptions options;
    options.particles = particles;
    options.refine = refine;
    options.aim = kFromTheRight;
    if (conform) options.tough = ToughCellOptions{.cells = 12, .conform = true};
    return fillWithParticles(SolidMesh(mesh), options);
}

TEST(Graded, AsManyCellsAsAskedForThatFillTheSameBody) {
    for (const TriangleMesh& mesh : {test::makeCube(1), test::makeVase(50, 30)})
        for (const double refine : {1.5, 3.0, 4.0}) {
            SCOPED_TRACE(mesh.name + " " + std::to_string(refine));
            const auto body = filled(mesh, 1500, refine);
            EXPECT_EQ(body->particles.size(), 1500u);
            EXPECT_EQ(body->cell_spacing.size(), 1500u);
            EXPECT_EQ(body->open_cells, 0u);
            EXPECT_NEAR(body->cells_volume / body->mesh_volume, 1, 1e-9);
        }
}

/// Edge of a cube of the cell's volume over the spacing that is wanted there.
TEST(Graded, SizesFollowTheField) {
    const auto body = filled(test::makeCube(1), 4000, 3);
    double mean = 0, squares = 0, near = 0, far = 0;
    size_t near_count = 0, far_count = 0;
    for (size_t i = 0; i < body->particles.size(); ++i) {
        const Particle& p = body->particles[i];
        const double edge = std::cbrt(p.volume), share = edge / body->cell_spacing[i];
        mean += share / double(body->particles.size());
        squares += share * share / double(body->particles.size());
        const double way = length(p.seed - Double3{0.5, 0, 0});
        if (way < 0.15) near += edge, ++near_count;
        if (way > 0.7) far += edge, ++far_count;
    }
    EXPECT_NEAR(mean, 1, 0.05);
    EXPECT_LT(std::sqrt(squares - mean * mean), 0.12);
    ASSERT_GT(near_count, 20u);
    ASSERT_GT(far_count, 20u);
    EXPECT_GT((far / double(far_count)) / (near / double(near_count)), 1.7);
}

TEST(Graded, BondsAndContactsKeepTheirMeasureOfTheCells) {
    const auto body = filled(test::makeCube(1), 2000, 3);
    for (const BondGeometry& bond : body->bonds) {
        const double finer = std::min(body->cell_spacing[bond.i], body->cell_spacing[bond.j]);
        ASSERT_GE(bond.area, 0.02 * finer * finer);
        ASSERT_GT(bond.length, 0.5 * finer);
    }
}

TEST(Graded, EvenIsAsItWas) {
    const auto even = filled(test::makeCube(1), 300, 1);
    FillOptions plain;
    plain.particles = 300;
    const auto before = fillWithParticles(SolidMesh(test::makeCube(1)), plain);
    EXPECT_TRUE(even->cell_spacing.empty());
    for (size_t i = 0; i < 300; ++i) ASSERT_EQ(even->particles[i].seed, before->particles[i].seed);
}

TEST(Graded, CanFollowToughCellsToo) {
    const auto body = filled(test::makeCube(1), 3000, 2.5, true);
    EXPECT_EQ(body->open_cells, 0u);
    EXPECT_GT(body->border_strength, 1.1);
    EXPECT_EQ(body->cell_spacing.size(), 3000u);
}

TEST(StruckPlace, IsWhatComesFirstOnTheWay) {
    const std::vector<Double3> places{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0.9, 0.2, 0}, {0, -1, 0.5}};
    EXPECT_EQ(struckPlace({.way = {-2, 0, 0}, .height = 0}, places, 0.1), places[0]);
    EXPECT_EQ(struckPlace({.way = {3, 0, 0}, .height = 0}, places, 0.1), places[1]);
    EXPECT_EQ(struckPlace({.way = {-1, 0, 0}, .through = Double3{0, 0.2, 0}}, places, 0.05), places[3]);
    EXPECT_EQ(struckPlace({.way = {-1, 0, 0}, .through = Double3{0, 5, 0}}, places, 0.1), places[2])
        << "a hole at the aim: what is nearest to the line";
    EXPECT_EQ(struckPlace({.way = {0, 1, 0}, .is_wall = true}, places, 0.1), places[4]);
}

}  // namespace
}  // namespace demolish
