// SPDX-License-Identifier: Apache-2.0
// Skins and morph targets of glTF files stand as viewers show them.
#include <gmock/gmock.h>

#include <bit>
#include <fstream>
#include <sstream>

#include "sim_cuda/api/model_file.h"
#include "sim_cuda/api/model_set.h"
#include "sim_cuda/authoring/bounds.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish {
namespace {

using RestPose = test::FileTest;

void replaceIn(const std::filesystem::path& file, const std::string& from, const std::string& to) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    std::string all = text.str();
    const size_t at = all.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(file) << all.replace(at, from.size(), to);
}

/// Which of the box's vertices lie above its middle, as the file has them.
std::vector<bool> upperVertices(const std::filesystem::path& folder) {
    std::ifstream bytes(folder / "box.bin", std::ios::binary);
    std::vector<bool> upper;
    for (int v = 0; v < 8; ++v) {
        float p[3];
        bytes.read(reinterpret_cast<char*>(p), sizeof p);
        upper.push_back(p[1] > 0);
    }
    return upper;
}

Double3 sizeOf(const std::filesystem::path& file) {
    return boundsOf(importModel(file).mesh.positions).size();
}

/// A box whose upper half hangs on the joint of node 2, the lower on that of node 1; `inverse_binds`: both,
/// column by column.
std::filesystem::path skinned(const std::filesystem::path& folder, const std::string& nodes,
                              const std::vector<float>& inverse_binds) {
    test::writeGltfSet(folder, "box.gltf", nodes, "[0,1,2]");
    std::vector<float> joints, weights;
    for (const bool is_upper : upperVertices(folder)) {
        joints.insert(joints.end(), {std::bit_cast<float>(is_upper ? 1u : 0u), 0});  // two numbers of 16 bits
        weights.insert(weights.end(), {1, 0, 0, 0});
    }
    const auto file = test::writeGltfSet(folder, "box.gltf", nodes, "[0,1,2]",
                                         R"(,"skins":[{"joints":[1,2],"inverseBindMatrices":4}])",
                                         {{"VEC4", joints}, {"VEC4", weights}, {"VEC4", inverse_binds}});
    replaceIn(file, R"("bufferView":2,"componentType":5126,"count":4)",
              R"("bufferView":2,"componentType":5123,"count":8)");
    replaceIn(file, R"("bufferView":4,"componentType":5126,"count":8,"type":"VEC4")",
              R"("bufferView":4,"componentType":5126,"count":2,"type":"MAT4")");
    replaceIn(file, R"({"POSITION":0})", R"({"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3})");
    return file;
}

/// Scales by `scale` and moves up by `up`, twice.
std::vector<float> binds(float scale, float up) {
    std::vector<float> both;
    for (int joint = 0; joint < 2; ++joint)
        both.insert(both.end(), {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, up, 0, 1});
    return both;
}

/// As exporters of centimetres write them: the node's own place does not count, the joints' does.
TEST_F(RestPose, SkinsStandWhereTheirJointsDo) {
    const auto file = skinned(
        folder(),
        R"([{"mesh":0,"skin":0,"scale":[9,9,9]},{"name":"low"},{"name":"high","translation":[0,3,0]}])",
        binds(0.5f, 0));
    const Double3 size = sizeOf(file);
    EXPECT_NEAR(size.x, 0.5, 1e-6);
    EXPECT_NEAR(size.y, 3.5, 1e-6);
    const ModelSet set = importSet(file);
    ASSERT_EQ(set.things.size(), 1u);
    EXPECT_NEAR(set.things[0].high.y - set.things[0].low.y, 3.5, 1e-6);
}

TEST_F(RestPose, SkinsThatMoveNothingLeaveEveryBit) {
    const std::string nodes =
        R"([{"mesh":0,"skin":0},{"name":"low","translation":[0,0.1,0]},{"name":"high","translation":[0,0.1,0]}])";
    const auto bound = importModel(skinned(folder(), nodes, binds(1, -0.1f))).mesh;
    const auto plain = importModel(test::writeGltfSet(folder(), "plain.gltf", R"([{"mesh":0}])", "[0]")).mesh;
    ASSERT_EQ(bound.positions.size(), plain.positions.size());
    for (size_t v = 0; v < bound.positions.size(); ++v) {
        EXPECT_EQ(bound.positions[v].x, plain.positions[v].x);
        EXPECT_EQ(bound.positions[v].y, plain.positions[v].y);
        EXPECT_EQ(bound.positions[v].z, plain.positions[v].z);
    }
}

TEST_F(RestPose, JointsNeedNoNames) {
    const Double3 size =
        sizeOf(skinned(folder(), R"([{"mesh":0,"skin":0},{},{"translation":[0,3,0]}])", binds(0.5f, 0)));
    EXPECT_NEAR(size.x, 0.5, 1e-6);
    EXPECT_NEAR(size.y, 3.5, 1e-6);
}

TEST_F(RestPose, MorphTargetsHaveTheirWeights) {
    std::vector<float> moves;
    test::writeGltfSet(folder(), "box.gltf", R"([{"mesh":0}])", "[0]");
    for (const bool is_upper : upperVertices(folder()))
        moves.insert(moves.end(), {0, is_upper ? 2.0f : 0.0f, 0});
    const auto file =
        test::writeGltfSet(folder(), "box.gltf", R"([{"mesh":0}])", "[0]", "", {{"VEC3", moves}});
    EXPECT_NEAR(sizeOf(file).y, 1, 1e-6);
    replaceIn(file, R"("indices":1}]})", R"("indices":1,"targets":[{"POSITION":2}]}],"weights":[0.5]})");
    EXPECT_NEAR(sizeOf(file).y, 2, 1e-6);
    EXPECT_NEAR(sizeOf(file).x, 1, 1e-6);
    EXPECT_EQ(importModel(file).looks, nullptr);
    replaceIn(file, R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0,"weights":[1]}])");
    const auto looks = importModel(file).looks;
    ASSERT_NE(looks, nullptr);
    EXPECT_TRUE(looks->materials.empty()) << "a note is no look";
    EXPECT_THAT(looks->notes, testing::ElementsAre(testing::HasSubstr("weights that nodes give")));
}

TEST_F(RestPose, NodesThatStandForManyAreSaid) {
    const auto file = test::writeGltfSet(
        folder(), "box.gltf",
        R"([{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}}])", "[0]");
    const auto looks = importModel(file).looks;
    ASSERT_NE(looks, nullptr);
    EXPECT_THAT(looks->notes, testing::ElementsAre(testing::HasSubstr("EXT_mesh_gpu_instancing")));
}

}  // namespace
}  // namespace demolish
