// SPDX-License-Identifier: Apache-2.0
// The program as reader, and stand-ins that do what a damaged file may make of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstring>

#include "app/reading/model_reader.h"
#include "app/reading/reading_limits.h"
#include "app/session/data_folder.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class ModelReader : public testing::Test {
  protected:
    ~ModelReader() override { setModelReader(""); }

    static void useTheProgram() {
        if (!fs::exists(DEMOLISH_PROGRAM)) GTEST_SKIP() << "the program is not built here";
        setModelReader(DEMOLISH_PROGRAM);
    }
    /// Reads by a shell script in the reader's place; what it is refused with.
    std::string refusalOf(const std::string& script, const ProgressCallback& progress = {}) {
        const fs::path reader = folder_.write("reader.sh", "#!/bin/sh\n" + script + "\n");
        fs::permissions(reader, fs::perms::owner_all);
        setModelReader(reader);
        try {
            readModel("some.obj", "", progress);
        } catch (const InputFileError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("The model 'some.obj'"), EndsWith(".")));
            return error.what();
        }
        ADD_FAILURE() << "accepted";
        return "";
    }
    test::TemporaryFolder folder_;
};

template <class Array>
bool sameBits(const Array& a, const Array& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

TEST_F(ModelReader, GivesTheBitsThatReadingInThisProcessGives) {
    useTheProgram();
    for (const char* name : {"block.obj", "wolf.obj"}) {
        const fs::path file = dataFolder() / "assets" / "models" / name;
        const TriangleMesh here = importTriangles(file), there = readModel(file).mesh;
        EXPECT_EQ(here.name, there.name);
        EXPECT_TRUE(sameBits(here.positions, there.positions));
        EXPECT_TRUE(sameBits(here.triangles, there.triangles));
        EXPECT_TRUE(sameBits(here.corners, there.corners));
    }
}

TEST_F(ModelReader, ReadsTheNodeThatIsAskedFor) {
    useTheProgram();
    const fs::path file = test::writeGltfSet(
        folder_.path(), "set.gltf",
        R"([{"name":"a b","mesh":0},{"name":"two","mesh":0,"translation":[3,0,0]}])", "[0,1]");
    EXPECT_EQ(readModel(file).mesh.triangles.size(), 24u);
    EXPECT_EQ(readModel(file, "a b").mesh.triangles.size(), 12u);
    EXPECT_THROW(readModel(file, "c"), InputFileError);
}

TEST_F(ModelReader, ReadsSeveralNodesAtOnceAndWhatStandsInASet) {
    useTheProgram();
    const fs::path file = test::writeGltfSet(
        folder_.path(), "set.gltf",
        R"([{"name":"red","mesh":0},{"name":"two","mesh":0,"translation":[3,0,0]}])", "[0,1]",
        R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}])");
    const std::vector<ImportedModel> both = readModels(file, {"two", "red"});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_TRUE(sameBits(both[0].mesh.positions, readModel(file, "two").mesh.positions));
    EXPECT_TRUE(sameBits(both[1].mesh.corners, readModel(file, "red").mesh.corners));
    EXPECT_EQ(both[0].looks, both[1].looks) << "sent once";
    EXPECT_THROW(readModels(file, {"red", "c"}), InputFileError);

    const ModelSet there = readModelSet(file), here = importSet(file);
    ASSERT_EQ(there.things.size(), 2u);
    EXPECT_EQ(there.things[1].node, "two");
    EXPECT_EQ(there.things[1].low, here.things[1].low);
    EXPECT_NEAR(there.things[1].high.x, 3.5, 1e-6);
    EXPECT_EQ(there.things[1].triangles, 12u);
    EXPECT_FALSE(there.camera || there.sun);
    EXPECT_THROW(readModelSet("no/such/set.glb"), InputFileError);
}

TEST_F(ModelReader, TurnsDownWithTheReadersOwnWords) {
    useTheProgram();
    try {
        readModel("no/such/file.obj");
        FAIL();
    } catch (const InputFileError& error) {
        EXPECT_STREQ(error.what(), "There is no model file 'no/such/file.obj'; check the path.");
    }
}

TEST_F(ModelReader, FindsWordsForEveryEndOfTheReader) {
    for (const char* signal : {"SEGV", "ABRT", "BUS", "FPE", "ILL"})
        EXPECT_THAT(refusalOf(std::string("kill -") + signal + " $$"), HasSubstr("crashed the reader"));
    EXPECT_THAT(refusalOf("kill -XCPU $$"), HasSubstr("took longer than 20 s"));
    EXPECT_THAT(refusalOf("kill -KILL $$"), HasSubstr("had its reader killed"));
    EXPECT_THAT(refusalOf("exit 90"), HasSubstr("GiB of memory"));
    EXPECT_THAT(refusalOf("exit 1"), HasSubstr("no usable answer"));
    EXPECT_THAT(refusalOf("exit 0"), HasSubstr("no usable answer"));
    EXPECT_THAT(refusalOf("echo DemoMesh"), HasSubstr("no usable answer"));
    EXPECT_THAT(refusalOf("head -c 100000 /dev/urandom"), HasSubstr("no usable answer"));
}

TEST_F(ModelReader, TimeGrowsWithTheFile) {
    EXPECT_EQ(mostReadingTime("/no/such/file").computing.count(), 20);
    const auto large = folder_.write("large.obj", "");
    fs::resize_file(large, uint64_t{100} << 20);
    EXPECT_EQ(mostReadingTime(large).computing.count(), 120);
    EXPECT_EQ(mostReadingTime(large).waiting.count(), 600);
}

TEST_F(ModelReader, SwallowsWhatTheReaderSays) {
    testing::internal::CaptureStderr();
    EXPECT_THAT(refusalOf("echo corrupted double-linked list >&2; kill -ABRT $$"), HasSubstr("crashed"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(ModelReader, CancelKillsTheReader) {
    const fs::path note = folder_.path() / "process";
    int asked = 0;
    const auto progress = [&](double fraction, const char* stage) {
        EXPECT_EQ(fraction, 0);
        EXPECT_STREQ(stage, "reading the model");
        return !fs::exists(note) || ++asked < 3;
    };
    EXPECT_THROW(refusalOf("echo $$ > " + note.string() + ".tmp; mv " + note.string() + ".tmp " +
                               note.string() + "; exec sleep 1000",
                           progress),
                 Cancelled);
    EXPECT_NE(kill(std::stoi(test::readText(note)), 0), 0) << "it still runs";
}

TEST_F(ModelReader, WithoutAReaderItIsADeviceErrorAndNotTheFiles) {
    setModelReader("/no/such/program");
    EXPECT_THROW(readModel("some.obj"), DeviceError);
}

}  // namespace
}  // namespace demolish
