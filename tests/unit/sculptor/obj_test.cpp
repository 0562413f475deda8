// SPDX-License-Identifier: Apache-2.0
// Normals, texture coordinates and the OBJ text.
#include "assets/models/obj_writer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "assets/models/marching.h"

namespace demolish::sculptor {
namespace {

Surface octahedron() {
    return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {4, 2, 1}, {1, 2, 5}, {5, 2, 0}, {4, 3, 0}, {1, 3, 4}, {5, 3, 1}, {0, 3, 5}}};
}

TEST(CornerNormals, SmoothOnesPointFromTheMiddleAndFlatOnesStandOnTheirTriangle) {
    const Surface surface = octahedron();
    ASSERT_TRUE(topologyOf(surface).closed);
    const auto smooth = cornerNormals(surface, 180), flat = cornerNormals(surface, 0);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(length(smooth[t][i] - surface.positions[surface.triangles[t][i]]), 0, 1e-12);
            EXPECT_NEAR(length(flat[t][i] - normalized(areaNormal(surface, surface.triangles[t]))), 0, 1e-12);
        }
}

TEST(CornerNormals, CreaseAngleDecides) {
    const Surface surface = octahedron();  // its faces meet at 70.5 degrees
    const auto sharp = cornerNormals(surface, 60), round = cornerNormals(surface, 80);
    EXPECT_NEAR(length(sharp[0][0] - normalized({1, 1, 1})), 0, 1e-12);
    EXPECT_GT(length(round[0][0] - normalized({1, 1, 1})), 0.1);
}

TEST(SphericalUvs, AreInRangeAndNoTriangleSpansTheSeam) {
    const Surface ball =
        marchTetrahedra([](Vec3 p) { return length(p) - 1; }, {{-1, -1, -1}, {1, 1, 1}}, 0.13);
    for (const auto& triangle : sphericalUvs(ball)) {
        for (const auto& uv : triangle) {
            EXPECT_GE(uv[1], 0);
            EXPECT_LE(uv[1], 1);
        }
        for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(triangle[i][0] - triangle[(i + 1) % 3][0]), 0.5);
    }
}

TEST(Obj, ListsEveryAttributeOnceAndHasNoNegativeZero) {
    Model model;
    model.surface = octahedron();
    for (Vec3& p : model.surface.positions) p = p - Vec3{0, 1e-9, 0};
    model.normals = cornerNormals(model.surface, 180);
    model.uvs = sphericalUvs(model.surface);
    const std::string text = objText(model, "octahedron");
    EXPECT_EQ(text.find("-0.000000 "), std::string::npos);
    EXPECT_NE(text.find("v 1.000000 0.000000 0.000000\n"), std::string::npos);
    std::size_t normals = 0, faces = 0;
    for (std::size_t at = 0; (at = text.find("\nvn ", at)) != std::string::npos; ++at) ++normals;
    for (std::size_t at = 0; (at = text.find("\nf ", at)) != std::string::npos; ++at) ++faces;
    EXPECT_EQ(normals, 6u);
    EXPECT_EQ(faces, 8u);
}

TEST(Obj, WritesTheWholeFileOrThrows) {
    const std::string file = testing::TempDir() + "sculptor_write.txt";
    writeText(file, "abc\n");
    std::ifstream in(file, std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "abc\n");
    EXPECT_FALSE(std::filesystem::exists(file + ".tmp"));
    std::filesystem::remove(file);
    EXPECT_THROW(writeText(testing::TempDir() + "no_such_folder/x.obj", "abc"), std::runtime_error);
}

}  // namespace
}  // namespace demolish::sculptor
