// SPDX-License-Identifier: Apache-2.0
// Files that crash, starve or hang whoever reads them: the program ends with code 3 and one sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string plyOfOneFace(const std::string& indices) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0\n1 0 0\n0 1 0\n3 " +
           indices + "\n";
}

/// Nodes within nodes, the last one with a mesh that is not there.
std::string gltfOfNodes(int depth) {
    std::string nodes;
    for (int k = 0; k + 1 < depth; ++k) nodes += "{\"children\":[" + std::to_string(k + 1) + "]},";
    return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" + nodes +
           "{\"mesh\":0}]}";
}

class BadModels : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    }
    static ProgramRun benchOf(const std::string& file, const std::vector<std::string>& prefix = {}) {
        return runProgram({"bench", "--no-draw", "--device", "cpu", "--particles", "50", "--frames", "1",
                           "--warmup", "0", "--model", file},
                          {}, prefix);
    }
    /// What stderr says: one sentence on one line, but for the progress bar.
    static void expectRefused(const ProgramRun& run, const std::string& about) {
        EXPECT_EQ(run.exit_code, 3) << run.err;
        const size_t begin = run.err.find("demolish: ");
        ASSERT_NE(begin, std::string::npos) << run.err;
        const std::string sentence = run.err.substr(begin);
        EXPECT_THAT(sentence, AllOf(HasSubstr(about), EndsWith(".\n")));
        EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 1) << sentence;
    }
    void expectRefused(const std::string& name, const std::string& text, const std::string& about) {
        SCOPED_TRACE(name);
        expectRefused(benchOf(folder_.write(name, text)), about);
    }
    TemporaryFolder folder_;
};

TEST_F(BadModels, FacesOfVerticesThatAreNotThere) {
    for (const char* indices : {"0 1 400000", "-5 1 2", "0 1 2147483647", "0 1 3"})
        expectRefused("face.ply", plyOfOneFace(indices), "face.ply' ");
}

TEST_F(BadModels, FilesThatCrashTheirReader) {
    expectRefused("text.raw", "Lorem ipsum dolor sit amet,\n consectetur adipiscing elit 1 2 3\n",
                  "text.raw' ");
    expectRefused("half.glb", std::string("glTF\2\0\0\0\xff\xff\xff\x7f\xff\xff\xff\x7fJSON", 20),
                  "half.glb' ");
    expectRefused("empty.glb", "", "empty.glb' ");
}

TEST_F(BadModels, CountsThatNobodyHasMemoryFor) {
    for (const char* counts : {"3 2000000000 0", "2000000000 1 0", "4000000000 4000000000 0", "3 -1 0"})
        expectRefused("huge.off", std::string("OFF\n") + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                      "huge.off' ");
}

TEST_F(BadModels, AHeaderThatItsReaderNeverComesToTheEndOf) {
    const std::string whole = plyOfOneFace("0 1 2");
    std::string torn = whole;
    torn.resize(whole.find("element face") + 10);
    const std::string file = folder_.write("torn.ply", torn + whole.substr(whole.find("0 0 0")));
    // Two seconds of a processor, so that nobody waits for the twenty that it would have.
    expectRefused(benchOf(file, {"bash", "-c", "ulimit -t 2; exec \"$@\"", "bash"}), "torn.ply' ");
}

TEST_F(BadModels, DeepNesting) {
    expectRefused("nested.gltf", gltfOfNodes(200), "nested.gltf' ");
    expectRefused("deeper.gltf", gltfOfNodes(200000), "deeper.gltf' ");
    expectRefused("brackets.gltf", std::string(500000, '['), "brackets.gltf' ");
}

TEST_F(BadModels, WhatIsNoPlainFile) {
    expectRefused(benchOf(folder_.path()), "is a folder");
    expectRefused(benchOf("/dev/zero"), "is not a plain file");
    const fs::path fifo = folder_.path() / "fifo.obj";
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    expectRefused(benchOf(fifo, {"timeout", "60"}), "is not a plain file");
    fs::create_symlink(folder_.path() / "nowhere.obj", folder_.path() / "link.obj");
    expectRefused(benchOf(folder_.path() / "link.obj"), "There is no model file");
    expectRefused(benchOf(folder_.path() / "removed.obj"), "There is no model file");
}

TEST_F(BadModels, AFileThatNobodyMayRead) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const fs::path file = folder_.write("secret.obj", "v 0 0 0\n");
    fs::permissions(file, fs::perms::none);
    expectRefused(benchOf(file), "secret.obj' ");
}

TEST_F(BadModels, AnOptionAsNameIsAFile) {
    folder_.write("-x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n");
    expectRefused(runProgram({"bench", "--no-draw", "--device", "cpu", "--model=-x.obj"}, {},
                             {"env", "--chdir", folder_.path()}),
                  "-x.obj' has no triangles");
}

TEST_F(BadModels, EveryCommandReadsThemSo) {
    const std::string file = folder_.write("face.ply", plyOfOneFace("0 1 400000"));
    expectRefused(runProgram({"calibrate", "--device", "cpu", "--model", file}), "face.ply' ");
    expectRefused(
        runProgram({"capture", "--device", "cpu", "--model", file, "--out", folder_.path() / "out"}),
        "face.ply' ");
}

}  // namespace
}  // namespace demolish::test
