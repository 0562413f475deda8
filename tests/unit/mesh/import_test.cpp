// SPDX-License-Identifier: Apache-2.0
// Good files: what comes in is the same solid, whatever the format and the scene around it.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/gltf_set.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

using test::FileTest;
using test::objText;

TEST_F(FileTest, CubeOfSeparateFacesIsWeldedToEightVertices) {
    std::string text;  // four vertices a face, quads, normals and texture coordinates
    const TriangleMesh cube = test::makeCube(2);
    int next = 1;
    text += "vt 0.25 0.5\nvn 0 0 1\n";
    for (size_t f = 0; f < cube.triangles.size(); f += 2) {
        const auto &a = cube.triangles[f], &b = cube.triangles[f + 1];
        for (const uint32_t v : {a[0], a[1], a[2], b[2]}) {
            const Double3& p = cube.positions[v];
            text += "v " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
        }
        text += "f";
        for (int k = 0; k < 4; ++k) text += ' ' + std::to_string(next++) + "/1/1";
        text += '\n';
    }
    const TriangleMesh mesh = importTriangles(write("quads.obj", text));
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(openEdgeCount(mesh), 0u);
    EXPECT_DOUBLE_EQ(enclosedVolume(mesh), 8);
    EXPECT_DOUBLE_EQ(surfaceArea(mesh), 24);
    for (const auto& corners : mesh.corners)
        for (const CornerAttributes& corner : corners) {
            EXPECT_FLOAT_EQ(corner.uv.x, 0.25f);
            EXPECT_FLOAT_EQ(corner.uv.y, 0.5f);
            EXPECT_FLOAT_EQ(corner.normal.z, 1);  // the file's, not the face's
        }
}

TEST_F(FileTest, FaceNormalsWhereTheFileHasNone) {
    const TriangleMesh mesh = importTriangles(write("bare.obj", objText(test::makeTorus(1, 0.3, 16, 8))));
    ASSERT_EQ(mesh.corners.size(), mesh.triangles.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const Double3 n = normalized(
            cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]));
        for (const CornerAttributes& corner : mesh.corners[i]) {
            EXPECT_NEAR(corner.normal.x, n.x, 1e-6);
            EXPECT_NEAR(corner.normal.y, n.y, 1e-6);
            EXPECT_NEAR(corner.normal.z, n.z, 1e-6);
        }
    }
}

TEST_F(FileTest, TrianglesThatCollapseInWeldingAreDropped) {
    const std::string text = objText(test::makeCube(1)) + "v 9 9 9\nv -0.5 -0.5 -0.5\nf 1 2 10\nf 1 2 2\n";
    const TriangleMesh mesh = importTriangles(write("degenerate.obj", text));
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(mesh.positions.size(), 8u);  // the stray vertex is gone too
    EXPECT_EQ(openEdgeCount(mesh), 0u);
}

/// Node transforms (quarter turn about z, 2 x 3 x 4 stretch, shift), then back to a closed solid of known
/// volume.
TEST_F(FileTest, SceneTransformsAreAppliedInGlbFbxAndCollada) {
    const TriangleMesh torus = test::makeTorus(1, 0.3, 24, 12);
    const double volume = test::signedVolume(torus);
    for (const auto& [name, format] : {std::pair{"t.glb", "glb2"}, {"t.dae", "collada"}, {"t.fbx", "fbxa"}}) {
        SCOPED_TRACE(name);
        const TriangleMesh mesh = importTriangles(exportMesh(torus, name, format));
        const double unit = std::string(format) == "fbxa" ? 0.01 : 1;  // FBX counts in centimetres
        EXPECT_EQ(mesh.positions.size(), torus.positions.size());
        EXPECT_EQ(openEdgeCount(mesh), 0u);
        EXPECT_NEAR(enclosedVolume(mesh) / (24 * volume * unit * unit * unit), 1, 1e-5);
        const Bounds bounds =
            boundsOf(mesh.positions);  // the turn puts y (0.3) along -x and x (1.3) along y, then the stretch
        EXPECT_NEAR(bounds.lower.x, unit * (5 - 0.6), 1e-4 * unit);
        EXPECT_NEAR(bounds.upper.y, unit * (6 + 3.9), 1e-4 * unit);
        EXPECT_NEAR(bounds.upper.z, unit * (7 + 5.2), 1e-4 * unit);
    }
}

TEST_F(FileTest, MirroredNodeStaysOutward) {
    const TriangleMesh vase = test::makeVase(20, 20);
    const auto file = exportMesh(vase, "mirrored.glb", "glb2", true);
    const TriangleMesh mesh = importTriangles(file);
    EXPECT_NEAR(enclosedVolume(mesh) / (24 * test::signedVolume(vase)), 1, 1e-5);
    EXPECT_NO_THROW(requireSolid(mesh, file));
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const Double3 n =
            cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
        const Float3& corner = mesh.corners[i][0].normal;
        EXPECT_GT(dot(n, {corner.x, corner.y, corner.z}), 0);
    }
}

TEST_F(FileTest, StlAndPlyInTextAndBinary) {
    const TriangleMesh sphere = test::makeSphere(1, 2);
    for (const auto& [name, format] : {std::pair{"s.stl", "stl"},
                                       {"b.stl", "stlb"},
                                       {"s.ply", "ply"},
                                       {"b.ply", "plyb"},
                                       {"s.obj", "obj"}}) {
        SCOPED_TRACE(format);
        const TriangleMesh mesh = importTriangles(exportMesh(sphere, name, format));
        EXPECT_EQ(mesh.positions.size(), sphere.positions.size());
        EXPECT_EQ(mesh.triangles.size(), sphere.triangles.size());
        EXPECT_EQ(openEdgeCount(mesh), 0u);
        EXPECT_NEAR(enclosedVolume(mesh) / (24 * test::signedVolume(sphere)), 1, 1e-4);
    }
}

/// The importer takes a line's end there for the rest of the header's.
TEST_F(FileTest, BinaryPlyWhoseNumbersBeginWithALinesEnd) {
    const TriangleMesh cube = test::makeCube(2);
    for (const std::string line : {"\n", "\r\n"}) {
        std::string text =
            "ply" + line + "format binary_little_endian 1.0" + line + "element vertex 8" + line;
        for (const char* axis : {"x", "y", "z"}) text += std::string("property float ") + axis + line;
        text +=
            "element face 12" + line + "property list uchar int vertex_indices" + line + "end_header" + line;
        const auto put = [&](auto value) {
            text.append(reinterpret_cast<const char*>(&value), sizeof value);
        };
        for (const Double3& p : cube.positions)
            for (const double x : {p.x, p.y, p.z}) {
                const auto bits = std::bit_cast<uint32_t>(static_cast<float>(x));
                put((bits & 0xffffff00) | 0x0a);
            }
        for (const auto& triangle : cube.triangles) {
            put(uint8_t(3));
            for (const uint32_t v : triangle) put(v);
        }
        const TriangleMesh mesh = importTriangles(write("cube.ply", text));
        ASSERT_EQ(mesh.positions.size(), 8u);
        ASSERT_EQ(mesh.triangles.size(), 12u);
        EXPECT_NEAR(enclosedVolume(mesh), 8, 1e-3);
    }
}

TEST_F(FileTest, StandsOnTheFloorAtTheWantedHeight) {
    TriangleMesh cube = test::makeCube(2);
    for (Double3& p : cube.positions) p = Double3{p.x * 3 + 10, p.y - 4, p.z * 0.5 + 7};
    const auto file = write("box.obj", objText(cube));
    const auto solid = loadSolidMesh(file, {.height = 0.5});
    const SolidMeshInfo& info = meshInfo(*solid);
    EXPECT_EQ(info.name, "box");
    EXPECT_EQ(info.vertices, 8u);
    EXPECT_EQ(info.triangles, 12u);
    EXPECT_NEAR(info.bounds_min.x, -0.75, 1e-12);
    EXPECT_NEAR(info.bounds_max.x, 0.75, 1e-12);
    EXPECT_EQ(info.bounds_min.y, 0);
    EXPECT_NEAR(info.bounds_max.y, 0.5, 1e-12);
    EXPECT_NEAR(info.bounds_min.z, -0.125, 1e-12);
    EXPECT_NEAR(info.volume, 1.5 * 0.5 * 0.25, 1e-12);
    EXPECT_NEAR(info.area, 2 * (1.5 * 0.5 + 0.5 * 0.25 + 0.25 * 1.5), 1e-12);

    const auto as_drawn = loadSolidMesh(file, {.keep_units = true});
    EXPECT_NEAR(meshInfo(*as_drawn).bounds_max.y, 2, 1e-12);
    const auto in_inches =
        loadSolidMesh(file, {.height = 3, .keep_units = true, .part = {"", UpAxis::kY, 0.0254}});
    EXPECT_NEAR(meshInfo(*in_inches).bounds_max.y, 2 * 3 * 0.0254, 1e-12);
    EXPECT_THROW(loadSolidMesh(file, {.height = 0}), UsageError);
    EXPECT_THROW(loadSolidMesh(file, {.height = std::nan("")}), UsageError);
}

TEST_F(FileTest, ZIsTurnedUpwardsWithItsNormals) {
    TriangleMesh cube = test::makeCube(2);
    for (Double3& p : cube.positions) p = Double3{p.x * 3, p.y * 2, p.z};
    const auto file = write("tall.obj", objText(cube));
    const auto solid = loadSolidMesh(file, {.keep_units = true, .part = {"", UpAxis::kZ}});
    EXPECT_NEAR(meshInfo(*solid).bounds_max.y, 2, 1e-12);
    EXPECT_NEAR(meshInfo(*solid).bounds_max.z, 2, 1e-12);
    EXPECT_NEAR(meshInfo(*solid).volume, 6 * 4 * 2, 1e-9);
    const TriangleMesh& mesh = solid->mesh();
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const Double3 face = normalized(
            cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]));
        const Float3& normal = mesh.corners[t][0].normal;
        EXPECT_NEAR(face.x * normal.x + face.y * normal.y + face.z * normal.z, 1, 1e-6);
    }
}

TEST_F(FileTest, ANodeIsItsOwnTrianglesOrWhatLiesBelowIt) {
    const auto file = test::writeGltfSet(
        folder(), "set.gltf",
        R"([{"name":"table","translation":[5,0,0],"scale":[2,2,2],"children":[1,2]},{"name":"top","mesh":0},
{"name":"leg","mesh":0,"translation":[0,2,0],"children":[3]},{"name":"leg","mesh":0,"translation":[0,1,0]}])",
        "[0]");
    const auto bounds = [&](const std::string& node) {
        return boundsOf(importModel(file, node).mesh.positions);
    };
    EXPECT_EQ(importTriangles(file).triangles.size(), 36u);
    EXPECT_EQ(importModel(file, "table").mesh.triangles.size(), 36u) << "it has none of its own";
    EXPECT_EQ(importModel(file, "leg").mesh.triangles.size(), 12u) << "without the one below it";
    EXPECT_NEAR(bounds("top").lower.x, 4, 1e-6);
    EXPECT_NEAR(bounds("leg").lower.y, 3, 1e-6);
    EXPECT_NEAR(bounds("leg#2").upper.y, 7, 1e-6);
    try {
        importModel(file, "leg#3");
        FAIL() << "accepted";
    } catch (const InputFileError& error) {
        EXPECT_NE(
            std::string(error.what()).find("has no node 'leg#3'; those with triangles are top, leg, leg#2"),
            std::string::npos)
            << error.what();
    }
}

TEST_F(FileTest, ParticleSizeGivesTheCountOrNamesWhatIsPossible) {
    const auto solid = loadSolidMesh(write("cube.obj", objText(test::makeCube(1))), {.height = 1});
    EXPECT_EQ(particlesForSize(*solid, 0.1), 1000u);
    EXPECT_EQ(particlesForSize(*solid, 0.01), 1'000'000u);
    for (const double size : {0.9, 0.005, 0.0, -0.1, std::nan("")}) {
        SCOPED_TRACE(size);
        try {
            particlesForSize(*solid, size);
            FAIL() << "accepted";
        } catch (const UsageError& error) {
            EXPECT_NE(std::string(error.what()).find("choose one from"), std::string::npos) << error.what();
        }
    }
    EXPECT_EQ(particlesForSize(*solid, std::cbrt(1.0 / kMinParticles) * 0.998), kMinParticles);
    EXPECT_LE(particlesForSize(*solid, std::cbrt(1.0 / kMaxParticles) * 1.002), kMaxParticles);
}

}  // namespace
}  // namespace demolish
