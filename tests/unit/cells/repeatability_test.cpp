// SPDX-License-Identifier: Apache-2.0
// The same bits for one thread and for two, and whatever the order in which the seeds are numbered.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "sim_cuda/authoring/body_parts.h"
#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/cells/test_bodies.h"

namespace demolish::test {
namespace {

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

CellComplex buildWith(size_t threads, const QueriedMesh& body, const std::vector<Double3>& seeds) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return buildCellComplex(body.mesh, body.queries, seeds, spacingOf(body.mesh, seeds.size()), 1);
}

void expectSameBits(const CellComplex& a, const CellComplex& b) {
    EXPECT_TRUE(sameBits(a.seeds, b.seeds));
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (size_t v = 0; v < a.vertices.size(); ++v) {  // one by one: the struct has padding
        ASSERT_EQ(a.vertices[v].key, b.vertices[v].key);
        ASSERT_EQ(std::memcmp(&a.vertices[v].position, &b.vertices[v].position, sizeof(Double3)), 0);
    }
    EXPECT_TRUE(sameBits(a.pieces, b.pieces));
    EXPECT_TRUE(sameBits(a.exterior_loop, b.exterior_loop));
    EXPECT_TRUE(sameBits(a.exterior_barycentrics, b.exterior_barycentrics));
    EXPECT_TRUE(sameBits(a.exterior_across, b.exterior_across));
    EXPECT_TRUE(sameBits(a.faces, b.faces));
    EXPECT_TRUE(sameBits(a.loop_start, b.loop_start));
    EXPECT_TRUE(sameBits(a.loop_vertices, b.loop_vertices));
    EXPECT_TRUE(sameBits(a.face_triangles, b.face_triangles));
}

TEST(Repeatability, SameBitsForOneAndTwoThreads) {
    for (const char* name : {"torus", "overlapping_boxes", "vase"}) {
        SCOPED_TRACE(name);
        const QueriedMesh& body = *testBody(name);
        const std::vector<Double3> seeds = randomSeeds(body.mesh, body.queries, 3000, 5);
        const CellComplex one = buildWith(1, body, seeds), two = buildWith(2, body, seeds);
        expectSameBits(one, two);
        EXPECT_EQ(one.rejitter_rounds, two.rejitter_rounds);
    }
}

TEST(Repeatability, RepairIsTheSameForOneAndTwoThreads) {
    const QueriedMesh& cube = *testBody("cube");
    std::vector<Double3> seeds;
    for (int k = 0; k < 216; ++k)
        seeds.push_back({(k % 6 - 2.5) / 6, (k / 6 % 6 - 2.5) / 6, (k / 36 - 2.5) / 6});
    const CellComplex one = buildWith(1, cube, seeds), two = buildWith(2, cube, seeds);
    EXPECT_GT(one.rejitter_rounds, 0u);
    expectSameBits(one, two);
}

TEST(Repeatability, BondsDoNotDependOnTheNumberingOfSeeds) {
    const QueriedMesh& body = *testBody("torus");
    const double spacing = spacingOf(body.mesh, 2000);
    const std::vector<Double3> seeds = randomSeeds(body.mesh, body.queries, 2000, 9);
    const std::vector<Double3> reversed(seeds.rbegin(), seeds.rend());
    const auto forward = makeBonds(buildWith(2, body, seeds), spacing);
    const auto backward = makeBonds(buildWith(2, body, reversed), spacing);
    std::map<std::pair<uint32_t, uint32_t>, const BondGeometry*> by_pair;
    for (const BondGeometry& bond : backward) by_pair[{1999 - bond.j, 1999 - bond.i}] = &bond;
    ASSERT_EQ(forward.size(), backward.size());
    for (const BondGeometry& bond : forward) {
        const BondGeometry* other = by_pair[{bond.i, bond.j}];
        ASSERT_NE(other, nullptr);
        ASSERT_NEAR(bond.area, other->area, 1e-12 * spacing * spacing);
        ASSERT_EQ(bond.length, other->length);
        ASSERT_EQ(bond.normal.x, -other->normal.x);
    }
}

}  // namespace
}  // namespace demolish::test
