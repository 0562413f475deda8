// SPDX-License-Identifier: Apache-2.0
// Cells are closed and fill the mesh, whatever the mesh and the number of seeds (geometry.md 7).
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "sim_cuda/authoring/double3.h"
#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/cells/test_bodies.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

class CellComplexOf : public testing::TestWithParam<std::tuple<std::string, uint32_t>> {};

void expectSortedAndUsed(const CellComplex& complex) {
    EXPECT_TRUE(
        std::is_sorted(complex.pieces.begin(), complex.pieces.end(), [](const auto& a, const auto& b) {
            return std::tie(a.cell, a.triangle) < std::tie(b.cell, b.triangle);
        }));
    EXPECT_TRUE(std::is_sorted(complex.faces.begin(), complex.faces.end(), [](const auto& a, const auto& b) {
        return std::tie(a.cell_a, a.cell_b) < std::tie(b.cell_a, b.cell_b);
    }));
    for (const ComplexFace& face : complex.faces) ASSERT_LT(face.cell_a, face.cell_b);
    for (size_t v = 1; v < complex.vertices.size(); ++v)
        ASSERT_LT(complex.vertices[v - 1].key, complex.vertices[v].key);
    std::vector<char> is_used(complex.vertices.size(), 0);
    for (const uint32_t id : complex.exterior_loop) is_used[id] = 1;
    for (const uint32_t id : complex.loop_vertices) is_used[id] = 1;
    EXPECT_EQ(std::count(is_used.begin(), is_used.end(), 0), 0);
}

TEST_P(CellComplexOf, IsClosedAndFillsTheMesh) {
    const auto& [name, count] = GetParam();
    const QueriedMesh* body = testBody(name);
    if (!body) GTEST_SKIP() << "no model file of " << name;
    const CellComplex complex =
        buildCellComplex(body->mesh, body->queries, randomSeeds(body->mesh, body->queries, count, 7),
                         spacingOf(body->mesh, count), 1);
    ASSERT_EQ(complex.seeds.size(), count);
    EXPECT_EQ(countOpenCells(complex), 0u);
    EXPECT_TRUE(complex.open_cells.empty());
    EXPECT_EQ(countCutOffParts(complex), 0u);
    EXPECT_EQ(complex.rejitter_rounds, 0u);
    const double volume = signedVolume(body->mesh), area = meshArea(body->mesh);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), volume, 1e-9 * volume);
    EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0);
    EXPECT_NEAR(exteriorArea(complex), area, 1e-9 * area);
    EXPECT_TRUE(triangulationsFitLoops(complex));
    if (name != "overlapping_boxes") {
        EXPECT_LT(excessTriangleArea(complex), 1e-9 * area);
    }
    expectSortedAndUsed(complex);
}

const auto kNameOf = [](const auto& info) {
    std::string name = std::get<0>(info.param) + "_" + std::to_string(std::get<1>(info.param));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
};

#ifdef DEMOLISH_SLOW_CELLS
INSTANTIATE_TEST_SUITE_P(Large, CellComplexOf,
                         testing::Combine(testing::Values("torus", "sphere", "vase", "overlapping_boxes",
                                                          "hollow_box", "bunny", "asteroid-high",
                                                          "asteroid-low", "rabbit"),
                                          testing::Values(20000u)),
                         kNameOf);
INSTANTIATE_TEST_SUITE_P(TwelveTriangles, CellComplexOf, testing::Values(std::tuple("cube", 100000u)),
                         kNameOf);
#else
INSTANTIATE_TEST_SUITE_P(Few, CellComplexOf,
                         testing::Combine(testing::Values("cube", "torus", "sphere", "vase",
                                                          "overlapping_boxes", "hollow_box", "bunny"),
                                          testing::Values(1u, 2u, 10u, 50u)),
                         kNameOf);
INSTANTIATE_TEST_SUITE_P(Many, CellComplexOf,
                         testing::Combine(testing::Values("cube", "torus", "sphere", "vase",
                                                          "overlapping_boxes", "hollow_box", "bunny",
                                                          "asteroid-high", "asteroid-low", "rabbit"),
                                          testing::Values(200u, 1000u, 5000u)),
                         kNameOf);
INSTANTIATE_TEST_SUITE_P(Large, CellComplexOf,
                         testing::Values(std::tuple("cube", 20000u), std::tuple("vase", 20000u),
                                         std::tuple("bunny", 20000u)),
                         kNameOf);
#endif

}  // namespace
}  // namespace demolish::test
