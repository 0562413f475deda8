// SPDX-License-Identifier: Apache-2.0
// Mass properties against closed forms, bonds against the statistics of geometry.md 5.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/packing.h"
#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/cells/test_bodies.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

const Double3 kSides{1, 2, 3}, kCentre{0.2, -0.4, 5};

QueriedMesh makeBox() {
    TriangleMesh mesh = makeCube(1);
    for (Double3& p : mesh.positions) p = kCentre + Double3{p.x * kSides.x, p.y * kSides.y, p.z * kSides.z};
    return QueriedMesh(std::move(mesh));
}

/// Sums of the cells' mass properties at unit density; inertia about kCentre by the parallel-axis rule.
struct Whole {
    double volume = 0;
    Double3 moment;
    SymmetricTensor inertia;
};

Whole sumUp(const std::vector<Particle>& particles) {
    Whole whole;
    for (const Particle& p : particles) {
        const Double3 d = p.centroid - kCentre;
        whole.volume += p.volume;
        whole.moment += p.centroid * p.volume;
        whole.inertia.xx += p.inertia.xx + p.volume * (d.y * d.y + d.z * d.z);
        whole.inertia.yy += p.inertia.yy + p.volume * (d.z * d.z + d.x * d.x);
        whole.inertia.zz += p.inertia.zz + p.volume * (d.x * d.x + d.y * d.y);
        whole.inertia.xy += p.inertia.xy - p.volume * d.x * d.y;
        whole.inertia.yz += p.inertia.yz - p.volume * d.y * d.z;
        whole.inertia.zx += p.inertia.zx - p.volume * d.z * d.x;
    }
    return whole;
}

class MassOfBox : public testing::TestWithParam<uint32_t> {};

TEST_P(MassOfBox, AddsUpToTheClosedForm) {
    const QueriedMesh box = makeBox();
    const CellComplex complex =
        buildCellComplex(box.mesh, box.queries, randomSeeds(box.mesh, box.queries, GetParam(), 3),
                         std::cbrt(6.0 / GetParam()), 1);
    const Whole whole = sumUp(massProperties(box.mesh, box.queries, complex));
    EXPECT_NEAR(whole.volume, 6, 1e-10);
    EXPECT_LT(length(whole.moment * (1 / 6.0) - kCentre), 1e-10);
    EXPECT_NEAR(whole.inertia.xx, 0.5 * (4 + 9), 1e-10);
    EXPECT_NEAR(whole.inertia.yy, 0.5 * (9 + 1), 1e-10);
    EXPECT_NEAR(whole.inertia.zz, 0.5 * (1 + 4), 1e-10);
    EXPECT_NEAR(whole.inertia.xy, 0, 1e-10);
    EXPECT_NEAR(whole.inertia.yz, 0, 1e-10);
    EXPECT_NEAR(whole.inertia.zx, 0, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Cells, MassOfBox, testing::Values(1u, 2u, 30u, 1500u));

TEST(MassProperties, EveryCellIsPositiveWithItsCentroidInItsVoronoiCell) {
    const QueriedMesh& body = *testBody("torus");
    const CellComplex complex = buildCellComplex(
        body.mesh, body.queries, randomSeeds(body.mesh, body.queries, 800, 3), spacingOf(body.mesh, 800), 1);
    for (const Particle& p : massProperties(body.mesh, body.queries, complex)) {
        ASSERT_GT(p.volume, 0);
        ASSERT_GT(p.depth, 0);
        ASSERT_LE(p.lowest, p.centroid.y);
        const SymmetricTensor& i = p.inertia;
        ASSERT_GE(i.xx + i.yy, i.zz);  // true of any mass
        ASSERT_GE(i.yy + i.zz, i.xx);
        ASSERT_GE(i.zz + i.xx, i.yy);
        for (const Double3& other : complex.seeds)
            ASSERT_LE(length(p.centroid - p.seed), length(p.centroid - other) + 1e-12);
    }
}

TEST(MassProperties, DepthAndLowestPointOfACube) {
    const QueriedMesh& cube = *testBody("cube");
    const std::vector<Double3> seeds{{0.1, 0.3, -0.2}, {0.05, -0.25, 0.1}};
    const auto particles = massProperties(
        cube.mesh, cube.queries, buildCellComplex(cube.mesh, cube.queries, seeds, std::cbrt(0.5), 1));
    EXPECT_NEAR(particles[0].depth, 0.2, 1e-14);
    EXPECT_NEAR(particles[1].depth, 0.25, 1e-14);
    EXPECT_EQ(particles[1].lowest, -0.5);
    // Lowest corner of the bisector where it meets the cube's edge x = -0.5, z = -0.5.
    const Double3 axis = seeds[0] - seeds[1], middle = (seeds[0] + seeds[1]) * 0.5;
    double expected = 1;
    for (const double x : {-0.5, 0.5})
        for (const double z : {-0.5, 0.5})
            expected =
                std::min(expected, middle.y - (axis.x * (x - middle.x) + axis.z * (z - middle.z)) / axis.y);
    EXPECT_NEAR(particles[0].lowest, expected, 1e-14);
}

TEST(Bonds, TwoHalvesOfAHollowBoxShareAFaceWithAHole) {
    const QueriedMesh box(joined(makeCube(1), turnedInsideOut(makeCube(0.5))));
    const CellComplex complex =
        buildCellComplex(box.mesh, box.queries, {{-0.3, 0.01, 0}, {0.3, 0.01, 0}}, std::cbrt(0.875 / 2), 1);
    ASSERT_EQ(complex.faces.size(), 1u);
    EXPECT_EQ(complex.faces[0].loop_count, 2u);
    double area = 0;  // of triangles, all turned towards +x
    for (const auto& [a, b, c] : complex.face_triangles) {
        const Double3& p = complex.vertices[a].position;
        const double x = cross(complex.vertices[b].position - p, complex.vertices[c].position - p).x;
        EXPECT_GE(x, 0);
        area += 0.5 * x;
    }
    EXPECT_NEAR(area, 0.75, 1e-14);
    const std::vector<BondGeometry> bonds = makeBonds(complex, std::cbrt(0.875 / 2));
    ASSERT_EQ(bonds.size(), 1u);
    EXPECT_NEAR(bonds[0].area, 0.75, 1e-14);
    EXPECT_NEAR(bonds[0].length, 0.6, 1e-14);
    EXPECT_LT(length(bonds[0].centroid), 1e-14);
    EXPECT_EQ(bonds[0].normal.x, 1);
}

TEST(Bonds, PackedBodyHasTheMeasuredStatistics) {
    const QueriedMesh* bunny = testBody("bunny");
    if (!bunny) GTEST_SKIP() << "no model file of the bunny";
    const uint32_t count = 5000;
    const double volume = signedVolume(bunny->mesh), spacing = spacingOf(bunny->mesh, count);
    const DistanceGrid grid(bunny->mesh, bunny->queries);
    const CellComplex complex = buildCellComplex(
        bunny->mesh, bunny->queries,
        packSeeds(bunny->mesh, bunny->queries, grid, evenSpacing(volume, count), count, 1), spacing, 1);
    EXPECT_EQ(countOpenCells(complex), 0u);
    const std::vector<BondGeometry> bonds = makeBonds(complex, spacing);
    double area_length = 0;
    for (size_t b = 0; b < bonds.size(); ++b) {
        const BondGeometry& bond = bonds[b];
        ASSERT_LT(bond.i, bond.j);
        if (b > 0) {
            ASSERT_LT(std::pair(bonds[b - 1].i, bonds[b - 1].j), std::pair(bond.i, bond.j));
        }
        ASSERT_GE(bond.area, 0.02 * spacing * spacing);
        const Double3 axis = complex.seeds[bond.j] - complex.seeds[bond.i];
        ASSERT_LT(length(axis - bond.normal * bond.length), 1e-14 * bond.length);
        // On the bisector, and inside the face's reach.
        const Double3 offset = bond.centroid - (complex.seeds[bond.i] + complex.seeds[bond.j]) * 0.5;
        ASSERT_LT(std::abs(dot(offset, bond.normal)), 1e-12 * spacing);
        ASSERT_LT(length(offset), 1.5 * spacing);
        area_length += bond.area * bond.length;
    }
    EXPECT_NEAR(area_length / (3 * volume), 0.934, 0.015);  // geometry.md 5, bunny at 5 k
    EXPECT_NEAR(2.0 * double(bonds.size()) / count, 12, 1.5);
}

TEST(Bonds, FacesAndSurfaceOfACellCloseAsVectors) {
    const QueriedMesh& body = *testBody("sphere");
    const CellComplex complex = buildCellComplex(
        body.mesh, body.queries, randomSeeds(body.mesh, body.queries, 500, 3), spacingOf(body.mesh, 500), 1);
    std::vector<Double3> sum(complex.seeds.size());
    for (const ExteriorPiece& piece : complex.pieces) {
        const auto at = [&](uint32_t k) {
            return complex.vertices[complex.exterior_loop[piece.first + k]].position;
        };
        for (uint32_t k = 2; k < piece.count; ++k)
            sum[piece.cell] += cross(at(k - 1) - at(0), at(k) - at(0)) * 0.5;
    }
    for (const BondGeometry& bond : makeBonds(complex, 0)) {
        sum[bond.i] += bond.normal * bond.area;
        sum[bond.j] += bond.normal * -bond.area;
    }
    for (const Double3& s : sum) ASSERT_LT(length(s), 1e-13);
}

}  // namespace
}  // namespace demolish::test
