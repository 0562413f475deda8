// SPDX-License-Identifier: Apache-2.0
// Pictures are repeated, moved and turned over the UVs as each format says.
#include <gmock/gmock.h>

#include <tuple>

#include "sim_cuda/api/model_file.h"
#include "tests/unit/looks/look_files.h"
#include "tests/unit/mesh/mesh_files.h"

namespace demolish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using LaidPictures = test::FileTest;

std::string cubeLaid(const std::string& laid, const std::string& more = "") {
    return test::cubeGlb(
        R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0)" + laid + "}}" + more + "}",
        test::pngOf(2, 2, test::fourTexels()));
}
std::string transformOf(const std::string& numbers) {
    return R"(,"extensions":{"KHR_texture_transform":{)" + numbers + "}}";
}

/// glTF counts v downwards, and turns so that a quarter of a turn of half the size from (0, 1) shows the
/// lower left quarter of the picture (the example of its text).
TEST_F(LaidPictures, PicturesAreRepeatedMovedAndTurnedAsGltfSays) {
    const ImportedModel plain = importModel(write("a.glb", cubeLaid("")));
    const ImportedModel repeated =
        importModel(write("b.glb", cubeLaid(transformOf(R"("scale":[4,2],"offset":[0.1,0.2])"))));
    const ImportedModel turned = importModel(write(
        "c.glb", cubeLaid(transformOf(R"("scale":[0.5,0.5],"offset":[0,1],"rotation":1.57079632679)"))));
    EXPECT_TRUE(turned.looks->notes.empty());
    for (size_t t = 0; t < plain.mesh.corners.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const float u = plain.mesh.corners[t][k].uv.x, v = 1 - plain.mesh.corners[t][k].uv.y;
            EXPECT_NEAR(repeated.mesh.corners[t][k].uv.x, 4 * u + 0.1f, 1e-5);
            EXPECT_NEAR(repeated.mesh.corners[t][k].uv.y, 1 - (2 * v + 0.2f), 1e-5);
            EXPECT_NEAR(turned.mesh.corners[t][k].uv.x, 0.5f * v, 1e-5);
            EXPECT_NEAR(turned.mesh.corners[t][k].uv.y, 1 - (1 - 0.5f * u), 1e-5);
        }
}

TEST_F(LaidPictures, PicturesOfOneMaterialThatAreLaidUnlikeFollowTheColours) {
    const ImportedModel model = importModel(
        write("cube.glb", cubeLaid(transformOf(R"("scale":[4,4])"), R"(,"normalTexture":{"index":0})")));
    EXPECT_THAT(model.looks->notes,
                ElementsAre(HasSubstr("is laid otherwise than the others of its material")));
    float most = 0;
    for (const auto& corners : model.mesh.corners)
        for (const CornerAttributes& corner : corners) most = std::max(most, corner.uv.x);
    EXPECT_NEAR(most, 4, 1e-5);
}

/// u' = s u + o, v' likewise; v of OBJ grows upwards. Numbers that are left out stay as they are.
TEST_F(LaidPictures, PicturesAreRepeatedAndMovedAsOptionsOfAnMtlSay) {
    write("skin.png", test::pngOf(2, 2, test::fourTexels()));
    const auto file = write("cube.obj", test::cubeObj("cube.mtl"));
    const auto laidBy = [&](const std::string& options) {
        write("cube.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd " + options + " skin.png\n");
        return importModel(file);
    };
    const ImportedModel plain = laidBy("");
    for (const auto& [options, scale, offset] :
         {std::tuple{"-s 4 2 1 -o 0.1 0.2 0", Float2{4, 2}, Float2{0.1f, 0.2f}},
          {"-clamp on -s 4 2", Float2{4, 2}, Float2{0, 0}},
          {"-o 0.25", Float2{1, 1}, Float2{0.25f, 0}}}) {
        const ImportedModel laid = laidBy(options);
        ASSERT_NE(laid.looks, nullptr) << options;
        EXPECT_TRUE(laid.looks->notes.empty()) << laid.looks->notes[0];
        EXPECT_EQ(laid.looks->images.size(), 1u) << options;
        for (size_t t = 0; t < plain.mesh.corners.size(); ++t)
            for (size_t k = 0; k < 3; ++k) {
                const Float2 uv = plain.mesh.corners[t][k].uv;
                EXPECT_NEAR(laid.mesh.corners[t][k].uv.x, scale.x * uv.x + offset.x, 1e-5) << options;
                EXPECT_NEAR(laid.mesh.corners[t][k].uv.y, scale.y * uv.y + offset.y, 1e-5) << options;
            }
    }
    EXPECT_THAT(laidBy("-mm 0.1 2").looks->notes,
                ElementsAre("the option -mm of the texture 'skin.png' is not followed"));
}

TEST_F(LaidPictures, BumpsOfAnMtlAreAsStrongAsItSays) {
    const std::vector<uint8_t> flat = {128, 128, 255, 255, 128, 128, 255, 255,
                                       128, 128, 255, 255, 128, 128, 255, 255};
    write("bent skin.png", test::pngOf(2, 2, flat));
    write("cube.mtl", "newmtl skin\nKd 1 0 0\nmap_Bump -bm 0.5 bent skin.png\n");
    const ImportedModel model = importModel(write("cube.obj", test::cubeObj("cube.mtl")));
    ASSERT_NE(model.looks, nullptr);
    const LookMaterial& look = model.looks->materials[model.mesh.corners[0][0].material];
    EXPECT_EQ(look.normal_map.image, 0u);
    EXPECT_EQ(look.normal_scale, 0.5f);
}

/// As Maya writes them.
TEST_F(LaidPictures, PicturesAreRepeatedAndMovedAsColladaSays) {
    write("skin.png", test::pngOf(2, 2, test::fourTexels()));
    const std::string plain = test::cubeDae("skin.png"), empty = R"(<texture texture="samp" texcoord="UV"/>)";
    const auto laidBy = [&](const std::string& extra) {
        std::string text = plain;
        text.replace(text.find(empty), empty.size(),
                     R"(<texture texture="samp" texcoord="UV"><extra><technique profile="MAYA">)" + extra +
                         "</technique></extra></texture>");
        return importModel(write("cube.dae", text));
    };
    const ImportedModel whole = importModel(write("cube.dae", plain));
    const ImportedModel laid =
        laidBy("<repeatU>4</repeatU><repeatV>2</repeatV><offsetU>0.25</offsetU><offsetV>0.5</offsetV>");
    EXPECT_TRUE(laid.looks->notes.empty());
    for (size_t t = 0; t < whole.mesh.corners.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(laid.mesh.corners[t][k].uv.x, 4 * whole.mesh.corners[t][k].uv.x + 0.25f, 1e-5);
            EXPECT_NEAR(laid.mesh.corners[t][k].uv.y, 2 * whole.mesh.corners[t][k].uv.y + 0.5f, 1e-5);
        }
    for (const std::string same : {"<repeatU>1</repeatU><repeatV>1</repeatV>", "<repeatU>0</repeatU>"}) {
        const TriangleMesh mesh = laidBy(same).mesh;
        for (size_t t = 0; t < mesh.corners.size(); ++t)
            for (size_t k = 0; k < 3; ++k)
                EXPECT_EQ(mesh.corners[t][k].uv.x, whole.mesh.corners[t][k].uv.x) << same;
    }
    EXPECT_THAT(laidBy("<rotateUV>30</rotateUV>").looks->notes,
                ElementsAre("the turn of the texture 'skin.png' is not followed"));
}

}  // namespace
}  // namespace demolish
