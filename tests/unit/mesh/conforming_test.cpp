// SPDX-License-Identifier: Apache-2.0
// A packing that follows the borders of tough cells: how much of them, how near, and at what price.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <map>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

std::shared_ptr<const BreakableBody> filled(const TriangleMesh& mesh, uint32_t particles,
                                            const ToughCellOptions& tough, uint64_t seed = 1) {
    FillOptions options;
    options.particles = particles;
    options.seed = seed;
    options.draw_geometry = false;
    options.tough = tough;
    return fillWithParticles(SolidMesh(mesh), options);
}

/// Of the faces between tough cells.
struct BorderFaces {
    double area = 0;   // m^2, of all
    double bonds = 0;  // how many
    double teeth = 0;  // their area over that of the vectors of their borders, each summed up
};

/// Borders between planes and balls are near to flat: what a border's area vectors add up to is its area.
BorderFaces borderFaces(const BreakableBody& body) {
    std::map<std::pair<uint32_t, uint32_t>, Double3> border;
    BorderFaces faces;
    for (const BondGeometry& bond : body.bonds) {
        const uint32_t a = body.tough_cell[bond.i], b = body.tough_cell[bond.j];
        if (a == b) continue;
        faces.area += bond.area;
        ++faces.bonds;
        border[std::minmax(a, b)] += (a < b ? bond.area : -bond.area) * bond.normal;
    }
    double flat = 0;
    for (const auto& [cells, sum] : border) flat += length(sum);
    faces.teeth = faces.area / flat;
    return faces;
}

double nearestSeeds(const BreakableBody& body) {
    double nearest = 1e300;
    for (const BondGeometry& bond : body.bonds) nearest = std::min(nearest, bond.length);
    return nearest / body.spacing;
}

void expectWhole(const BreakableBody& body, uint32_t particles) {
    EXPECT_EQ(body.particles.size(), particles);
    EXPECT_EQ(body.tough_cell.size(), particles);
    EXPECT_EQ(body.open_cells, 0u);
    EXPECT_NEAR(body.cells_volume / body.mesh_volume, 1, 1e-9);
}

TEST(Conforming, FacesBetweenToughCellsLieInTheirBorder) {
    for (const TriangleMesh& mesh : {test::makeCube(1), test::makeSphere(1, 4)}) {
        SCOPED_TRACE(mesh.name);
        const auto any = filled(mesh, 3000, {.cells = 12});
        const auto conforming = filled(mesh, 3000, {.cells = 12, .conform = true});
        expectWhole(*any, 3000);
        expectWhole(*conforming, 3000);
        const BorderFaces teeth = borderFaces(*any), even = borderFaces(*conforming);
        EXPECT_GT(teeth.teeth, 1.4);  // 1.5 of an isotropic packing
        EXPECT_LT(even.teeth, 1.25);
        EXPECT_GT(nearestSeeds(*conforming), 0.5);  // substeps go with the shortest bonds
    }
}

TEST(Conforming, BordersAreAsStrongAgainstAStraightCutAsTeeth) {
    const auto any = filled(test::makeCube(1), 3000, {.cells = 12});
    const auto conforming = filled(test::makeCube(1), 3000, {.cells = 12, .conform = true});
    EXPECT_EQ(any->border_strength, 1);
    const double teeth = borderFaces(*any).area / borderFaces(*conforming).area;
    EXPECT_GT(teeth, 1.12);
    EXPECT_NEAR(conforming->border_strength / teeth, 1, 0.04);
}

TEST(Conforming, SameBitsForOneAndTwoThreads) {
    const auto fillWith = [](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return filled(test::makeTorus(1, 0.3, 40, 20), 2000, {.cells = 20, .conform = true}, 7);
    };
    const auto one = fillWith(1), two = fillWith(2);
    EXPECT_EQ(one->tough_cell, two->tough_cell);
    EXPECT_EQ(one->border_strength, two->border_strength);
    ASSERT_EQ(one->bonds.size(), two->bonds.size());
    for (size_t b = 0; b < one->bonds.size(); ++b) ASSERT_EQ(one->bonds[b].length, two->bonds[b].length);
}

TEST(Conforming, HoldsForFewParticlesThinWallsAndAnyNumberOfCells) {
    for (const TriangleMesh& mesh : {test::makeCube(1), test::makeVase(50, 30)})
        for (const uint32_t particles : {2u, 30u, 400u})
            for (const uint32_t cells : {0u, 1u, 2u, 25u, 300u, 100000u}) {
                SCOPED_TRACE(mesh.name + " " + std::to_string(particles) + " " + std::to_string(cells));
                const auto body = filled(mesh, particles, {.cells = cells, .conform = true});
                EXPECT_EQ(body->particles.size(), particles);
                EXPECT_EQ(body->open_cells, 0u);
                EXPECT_TRUE(body->tough_cell.empty() || body->tough_cell.size() == particles);
                EXPECT_TRUE(body->border_strength > 0.3 && body->border_strength < 1.6)
                    << body->border_strength;
            }
}

TEST(Conforming, FollowsPatterns) {
    for (const Pattern pattern :
         {Pattern::kUniform, Pattern::kRadial, Pattern::kSlabs, Pattern::kBricks, Pattern::kSplinters}) {
        SCOPED_TRACE(int(pattern));
        ToughCellOptions options{.cells = 10, .pattern = pattern};
        const auto any = filled(test::makeCube(1), 3000, options);
        options.conform = true;
        const auto conforming = filled(test::makeCube(1), 3000, options);
        expectWhole(*conforming, 3000);
        EXPECT_GT(conforming->border_strength, 1.1);
        std::map<uint32_t, size_t> cells;
        for (const uint32_t cell : conforming->tough_cell) ++cells[cell];
        EXPECT_NEAR(double(cells.size()), 10, 4);
    }
}

}  // namespace
}  // namespace demolish
