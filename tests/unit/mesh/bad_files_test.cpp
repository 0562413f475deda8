// SPDX-License-Identifier: Apache-2.0
// Bad files: each is refused with one sentence that names the file and what is wrong with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

using test::FileTest;
using test::objText;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

MeshPlacement withoutRepair() {
    MeshPlacement placement;
    placement.repair.mode = RepairMode::kOff;
    return placement;
}

void expectRefused(const std::filesystem::path& file, const std::string& reason,
                   const MeshPlacement& placement = {}) {
    SCOPED_TRACE(file.filename());
    try {
        loadSolidMesh(file, placement);
        FAIL() << "accepted";
    } catch (const InputFileError& error) {
        EXPECT_THAT(error.what(), HasSubstr(reason));
        EXPECT_THAT(error.what(), HasSubstr(file.string()));
        EXPECT_THAT(error.what(), EndsWith("."));
        EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
        EXPECT_EQ(error.code(), ExitCode::kInputFile);
    }
}

TEST_F(FileTest, MissingFileAndFolder) {
    const auto file = write("there.obj", "");
    expectRefused(file.parent_path() / "not_there.obj", "There is no model file");
    expectRefused(file.parent_path(), "is a folder");
    expectRefused("/dev/zero", "is not a plain file");
}

TEST_F(FileTest, EmptyFiles) {
    for (const char* name :
         {"empty.obj", "empty.ply", "empty.stl", "empty.glb", "empty.fbx", "empty.3ds", "empty"})
        expectRefused(write(name, ""), name);
}

TEST_F(FileTest, Garbage) {
    const std::string garbage = "Lorem ipsum dolor sit amet,\n consectetur adipiscing elit 1 2 3\n";
    for (const char* name :
         {"text.obj", "text.ply", "text.stl", "text.glb", "text.gltf", "text.fbx", "text.xyz"})
        expectRefused(write(name, garbage), name);
    std::string bytes;
    for (int i = 0; i < 4000; ++i) bytes += char(i * 7919 >> 3);
    for (const char* name : {"bytes.obj", "bytes.ply", "bytes.stl", "bytes.glb", "bytes.fbx", "bytes.3ds"})
        expectRefused(write(name, bytes), name);
}

TEST_F(FileTest, TruncatedBinaryStl) {
    const auto file = exportMesh(test::makeSphere(1, 2), "half.stl", "stlb");
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    expectRefused(file, "half.stl");
}

TEST_F(FileTest, NoFaces) {
    expectRefused(write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "points.obj");
    expectRefused(write("lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"), "no triangles");
}

TEST_F(FileTest, OpenBoxNamesItsOpenEdges) {
    expectRefused(write("lidless.obj", objText(test::makeCube(1), 2)), "not closed: 4 open edges",
                  withoutRepair());
    expectRefused(write("one_missing.obj", objText(test::makeSphere(1, 2), 1)), "not closed: 3 open edges",
                  withoutRepair());
}

TEST_F(FileTest, OneFaceTurnedIsNotClosed) {
    TriangleMesh cube = test::makeCube(1);
    std::swap(cube.triangles[5][0], cube.triangles[5][1]);
    expectRefused(write("turned.obj", objText(cube)), "not closed: 3 open edges", withoutRepair());
}

TEST_F(FileTest, SheetHasNoVolume) {
    expectRefused(write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1\n"),
                  "no volume", withoutRepair());
    expectRefused(write("all_equal.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"), "no triangles");
}

TEST_F(FileTest, InsideOutIsRefused) {
    expectRefused(write("inverted.obj", objText(test::turnedInsideOut(test::makeTorus(1, 0.3, 12, 8)))),
                  "inside out", withoutRepair());
}

TEST_F(FileTest, ASurfaceThatIsThereTwice) {
    TriangleMesh twice = test::makeCube(1);
    const size_t once = twice.triangles.size();
    for (size_t i = 0; i < once; ++i) {
        const auto t = twice.triangles[i];
        twice.triangles.push_back({t[1], t[2], t[0]});  // the same triangle, named from another corner
    }
    expectRefused(write("twice.obj", objText(twice)), "holds 12 triangles more than once", withoutRepair());
}

TEST_F(FileTest, FacesOfVerticesThatAreNotThere) {
    for (const char* index : {"3", "-5", "400000", "2147483647"})
        expectRefused(
            write("face.ply",
                  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                  "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n1 0 0\n0 1 0\n3 0 1 " +
                      std::string(index) + "\n"),
            "of a vertex that is not there");
}

TEST_F(FileTest, SizesBeyondWhatNumbersHold) {
    TriangleMesh cube = test::makeCube(1);
    for (Double3& p : cube.positions) p = {1e150 * p.x, 1e150 * p.y, 1e150 * p.z};
    EXPECT_THROW(makeSolidMesh(cube, "huge.obj"), InputFileError);
    cube = test::makeCube(1);
    for (Double3& p : cube.positions) p = {1e-100 * p.x, 1e-100 * p.y, 1e-100 * p.z};
    EXPECT_NO_THROW(makeSolidMesh(cube, "tiny.obj"));
}

TEST_F(FileTest, VerticesThatAreNotNumbers) {
    std::string text = objText(test::makeCube(1));
    for (const char* bad : {"nan", "inf"}) {
        const std::string line = "v " + std::string(bad) + " 0 0\n";
        EXPECT_NO_THROW(loadSolidMesh(write(std::string(bad) + "_unused.obj", text + line)));
        std::string broken = text;
        broken.replace(0, broken.find('\n') + 1, line);
        expectRefused(write(std::string(bad) + "_used.obj", broken), "not a finite number");
    }
}

/// In metres as files may say: larger ones crashed the packing, whose distances are single precision.
TEST_F(FileTest, SizesThatNoBodyCanHaveAreRefused) {
    const auto file = write("cube.obj", objText(test::makeCube(1)));
    const auto inUnitsOf = [](double unit) {
        return MeshPlacement{.height = 1, .keep_units = true, .part = {"", UpAxis::kY, unit}};
    };
    expectRefused(file, "would be 1e+30 m long, and a body can have 1e-06 to 10000 m", inUnitsOf(1e30));
    expectRefused(file, "would be 1e-20 m long", inUnitsOf(1e-20));
    EXPECT_NO_THROW(loadSolidMesh(file, inUnitsOf(0.99e4)));
    EXPECT_NO_THROW(loadSolidMesh(file, inUnitsOf(1.01e-6)));
}

}  // namespace
}  // namespace demolish
