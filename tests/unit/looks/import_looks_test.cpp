// SPDX-License-Identifier: Apache-2.0
// What files say of their looks arrives, whatever the format calls it; what cannot be taken is said.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "sim_cuda/api/model_file.h"
#include "tests/unit/looks/look_files.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

using test::FileTest;
using testing::ElementsAre;
using testing::HasSubstr;

using ImportLooks = FileTest;

/// Every side shows the whole picture, the right way up: u and v follow from the place.
void expectCubeUvs(const TriangleMesh& mesh) {
    ASSERT_EQ(mesh.triangles.size(), 12u);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& corners = mesh.corners[t];
        const Float3& n = corners[0].normal;
        const size_t axis = std::abs(n.x) > 0.5f ? 0 : std::abs(n.y) > 0.5f ? 1 : 2;
        for (size_t k = 0; k < 3; ++k) {
            const Double3& p = mesh.positions[mesh.triangles[t][k]];
            const double place[] = {p.x, p.y, p.z};
            EXPECT_NEAR(corners[k].uv.x, place[(axis + 1) % 3] + 0.5, 1e-6);
            EXPECT_NEAR(corners[k].uv.y, place[(axis + 2) % 3] + 0.5, 1e-6);
        }
    }
}

TEST_F(ImportLooks, BinaryGltfWithAnEmbeddedPicture) {
    const std::string material =
        R"({"doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.3,"emissiveFactor":[0.5,0,0],"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,1],"baseColorTexture":{"index":0},"metallicFactor":0.75,"roughnessFactor":0.5,"metallicRoughnessTexture":{"index":0}},"normalTexture":{"index":0,"scale":0.5},"occlusionTexture":{"index":0,"strength":0.25}})";
    std::vector<uint8_t> texels = test::fourTexels();
    texels[3] = 0;  // one hole
    const ImportedModel model =
        importModel(write("cube.glb", test::cubeGlb(material, test::pngOf(2, 2, texels))));
    expectCubeUvs(model.mesh);
    ASSERT_NE(model.looks, nullptr);
    EXPECT_TRUE(model.looks->notes.empty());
    ASSERT_EQ(model.looks->images.size(), 1u);
    EXPECT_EQ(model.looks->images[0].width, 2u);
    EXPECT_EQ(model.looks->images[0].texels, texels);
    const uint32_t number = model.mesh.corners[0][0].material;
    ASSERT_LT(number, model.looks->materials.size());
    const LookMaterial& look = model.looks->materials[number];
    EXPECT_THAT(look.base_colour, ElementsAre(0.5f, 1, 1, 1));
    EXPECT_THAT(look.emission, ElementsAre(0.5f, 0, 0));
    EXPECT_EQ(look.metallic, 0.75f);
    EXPECT_EQ(look.roughness, 0.5f);
    EXPECT_EQ(look.normal_scale, 0.5f);
    EXPECT_EQ(look.occlusion_strength, 0.25f);
    EXPECT_EQ(look.alpha_cutoff, 0.3f);
    EXPECT_EQ(look.is_double_sided, 1u);
    for (const ImageUse& use :
         {look.base_map, look.normal_map, look.metallic_map, look.roughness_map, look.occlusion_map})
        EXPECT_EQ(use.image, 0u);
    EXPECT_EQ(look.emission_map.image, kNoImage);
    EXPECT_EQ(look.roughness_map.channel, 1);
    EXPECT_EQ(look.metallic_map.channel, 2);
    EXPECT_EQ(look.occlusion_map.channel, 0);
}

TEST_F(ImportLooks, ASecondSetOfUvsIsTakenAndAThirdIsSaid) {
    const std::string material =
        R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"occlusionTexture":{"index":0,"texCoord":1},"emissiveTexture":{"index":0,"texCoord":2},"emissiveFactor":[1,1,1]})";
    const ImportedModel model =
        importModel(write("cube.glb", test::cubeGlb(material, test::pngOf(2, 2, test::fourTexels()))));
    ASSERT_NE(model.looks, nullptr);
    const LookMaterial& look = model.looks->materials[model.mesh.corners[0][0].material];
    EXPECT_EQ(look.base_map.uv_set, 0);
    EXPECT_EQ(look.occlusion_map.uv_set, 1);
    EXPECT_EQ(look.occlusion_map.image, 0u);
    EXPECT_EQ(look.emission_map.image, kNoImage);
    EXPECT_THAT(model.looks->notes, ElementsAre(HasSubstr("lies on a third set of UVs and is left out")));
    for (const auto& corners : model.mesh.corners)
        for (const CornerAttributes& corner : corners) {
            EXPECT_NEAR(corner.second_uv.x, 0.5f * corner.uv.x, 1e-6);
            EXPECT_NEAR(corner.second_uv.y, 0.25f * corner.uv.y, 1e-6);
        }
}

/// As bricks are, on whose bevels mortar sticks.
TEST_F(ImportLooks, AMaterialThatAnObjOnlyNamesIsTheBodysOwn) {
    write("wall.mtl", "newmtl mortar\nKd 0.5 0.4 0.3\n");
    const ImportedModel model = importModel(
        write("wall.obj",
              "mtllib wall.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl clay\nf 1 3 2\nf 1 2 4\n"
              "usemtl mortar\nf 1 4 3\nf 2 3 4\n"));
    ASSERT_NE(model.looks, nullptr);
    ASSERT_EQ(model.mesh.triangles.size(), 4u);
    int own = 0, mortar = 0;
    for (const auto& corners : model.mesh.corners) {
        const LookMaterial& look = model.looks->materials[corners[0].material];
        own += look.says_nothing == 1;
        mortar += look.says_nothing == 0 && look.base_colour[0] == 0.5f;
    }
    EXPECT_EQ(own, 2);
    EXPECT_EQ(mortar, 2);
}

TEST_F(ImportLooks, TheOnlySetOfUvsIsTakenWhateverItsNumber) {
    write("skin.png", test::pngOf(2, 2, test::fourTexels()));
    std::string text = test::cubeDae("skin.png");
    for (const std::string number : {" set=\"0\"", "input_set=\"0\""}) {
        ASSERT_NE(text.find(number), std::string::npos);
        text[text.find(number) + number.size() - 2] = '1';
    }
    const ImportedModel model = importModel(write("cube.dae", text));
    expectCubeUvs(model.mesh);
    ASSERT_NE(model.looks, nullptr);
    EXPECT_TRUE(model.looks->notes.empty());
    const LookMaterial& look = model.looks->materials[model.mesh.corners[0][0].material];
    EXPECT_EQ(look.base_map.image, 0u);
    EXPECT_EQ(look.base_map.uv_set, 0);
}

TEST_F(ImportLooks, PicturesOfAGltfThatOnlyAnExtensionNamesAreSaid) {
    const auto saying = [&](const std::string& texture) {
        return importModel(
                   write("cube.glb",
                         test::cubeGlb(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})",
                                       test::pngOf(2, 2, test::fourTexels()), false, "[{" + texture + "}]")))
            .looks;
    };
    const auto webp = saying(R"("extensions":{"EXT_texture_webp":{"source":0}})");
    ASSERT_NE(webp, nullptr);
    EXPECT_THAT(webp->notes, ElementsAre("the texture 'number 0' is WebP, which is not read "
                                         "(EXT_texture_webp): a plain colour instead; export it as PNG or "
                                         "JPEG"));
    const auto both = saying(R"("source":0,"extensions":{"EXT_texture_webp":{"source":0}})");
    ASSERT_NE(both, nullptr);
    EXPECT_TRUE(both->notes.empty());
    EXPECT_EQ(both->images.size(), 1u);
}

TEST_F(ImportLooks, WhatIsBlendedIsKeptAsThatWhereItLetsLightThrough) {
    const auto cutoffOf = [&](const std::string& material, std::vector<uint8_t> texels) {
        const ImportedModel model =
            importModel(write("cube.glb", test::cubeGlb(material, test::pngOf(2, 2, texels))));
        return model.looks->materials[model.mesh.corners[0][0].material].alpha_cutoff;
    };
    const std::string textured =
        R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
    std::vector<uint8_t> holed = test::fourTexels();
    holed[3] = 100;
    EXPECT_EQ(cutoffOf(textured, holed), kBlends);
    EXPECT_EQ(cutoffOf(textured, test::fourTexels()), 0) << "all of it is opaque";
    EXPECT_EQ(cutoffOf(R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.25]}})",
                       test::fourTexels()),
              kBlends);
}

/// Of an older extension, which tells specular and glossiness in place of metal and roughness.
TEST_F(ImportLooks, GlossyMaterialsOfGltfKeepTheirColour) {
    const ImportedModel model = importModel(write(
        "cube.glb",
        test::cubeGlb(
            R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,0.5,0,1],"glossinessFactor":0.75}}})",
            test::pngOf(2, 2, test::fourTexels()), false,
            R"([{"source":0}],"extensionsUsed":["KHR_materials_pbrSpecularGlossiness"])")));
    ASSERT_NE(model.looks, nullptr);
    const LookMaterial& look = model.looks->materials[model.mesh.corners[0][0].material];
    EXPECT_THAT(look.base_colour, ElementsAre(1, 0.5f, 0, 1));
    EXPECT_EQ(look.metallic, 0);
    EXPECT_EQ(look.roughness, 0.25f);
}

TEST_F(ImportLooks, OpacitiesAtTheVerticesAreKeptWhereTheyAreMeant) {
    const auto looking = [&](const std::string& material, float opacity) {
        const ImportedModel model =
            importModel(write("cube.glb", test::cubeGlb(material, test::pngOf(2, 2, test::fourTexels()), true,
                                                        R"([{"source":0}])", opacity)));
        return model.looks->materials[model.mesh.corners[0][0].material].alpha_cutoff;
    };
    EXPECT_EQ(looking(R"({"alphaMode":"BLEND"})", 0.25f), kBlends);
    EXPECT_EQ(looking(R"({"alphaMode":"MASK","alphaCutoff":0.75})", 0.25f), 0.75f);
    EXPECT_EQ(looking(R"({"alphaMode":"BLEND"})", 1), 0);
    EXPECT_EQ(looking("{}", 0.25f), 0) << "opaque, says the file";
}

TEST_F(ImportLooks, ColoursOfGltfAreLinear) {
    const std::string glb = test::cubeGlb("{}", test::pngOf(2, 2, test::fourTexels()), true);
    const ImportedModel model = importModel(write("cube.glb", glb));
    ASSERT_NE(model.looks, nullptr);
    EXPECT_TRUE(model.looks->has_colours);
    EXPECT_EQ(model.mesh.corners[5][1].colour, 0xffff89bcu);  // sRGB of 0.5, 0.25, 1
}

TEST_F(ImportLooks, WavefrontWithPicturesBesideIt) {
    write("skin.png", test::pngOf(2, 2, test::fourTexels()));
    write("rough.tga", test::tgaOf(2, 2, test::fourTexels()));
    write("cube.mtl", "newmtl skin\nKd 0.5 0.5 0.25\nmap_Kd skin.png\nmap_Pr C:\\\\old\\\\rough.tga\nPm 1\n");
    const ImportedModel model = importModel(write("cube.obj", test::cubeObj("cube.mtl")));
    expectCubeUvs(model.mesh);
    ASSERT_NE(model.looks, nullptr);
    EXPECT_TRUE(model.looks->notes.empty()) << model.looks->notes[0];
    const LookMaterial& look = model.looks->materials[model.mesh.corners[0][0].material];
    EXPECT_THAT(look.base_colour, ElementsAre(0.5f, 0.5f, 0.25f, 1));
    ASSERT_EQ(model.looks->images.size(), 2u);
    for (const LookImage& image : model.looks->images) EXPECT_EQ(image.texels, test::fourTexels());
    EXPECT_NE(look.base_map.image, look.roughness_map.image);
    EXPECT_EQ(look.roughness, 1) << "a map is multiplied by 1 where no number stands";
}

TEST_F(ImportLooks, ColladaWithAPictureBesideIt) {
    write("my skin.png", test::pngOf(2, 2, test::fourTexels()));
    const ImportedModel model = importModel(write("cube.dae", test::cubeDae("my%20skin.png")));
    expectCubeUvs(model.mesh);
    ASSERT_NE(model.looks, nullptr);
    ASSERT_EQ(model.looks->images.size(), 1u) << testing::PrintToString(model.looks->notes);
    EXPECT_EQ(model.looks->images[0].texels, test::fourTexels());
}

TEST_F(ImportLooks, ColoursOfPlyAreMeantForTheScreen) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 255 128 0\n1 0 0 255 128 0\n"
        "0 1 0 255 128 0\n0 0 1 255 128 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    const ImportedModel model = importModel(write("corner.ply", text));
    ASSERT_NE(model.looks, nullptr);
    EXPECT_TRUE(model.looks->has_colours);
    for (const auto& corners : model.mesh.corners)
        for (const CornerAttributes& corner : corners) EXPECT_EQ(corner.colour, 0xff0080ffu);
}

TEST_F(ImportLooks, FilesThatSayNothingHaveNone) {
    const ImportedModel bare = importModel(write("bare.obj", test::objText(test::makeCube(1))));
    EXPECT_EQ(bare.looks, nullptr);
    EXPECT_EQ(bare.mesh.corners[0][0].material, kNoMaterial);
    EXPECT_EQ(importModel(exportMesh(test::makeCube(1), "bare.stl", "stl")).looks, nullptr);
}

/// The note on the one picture of a cube.
std::string noteOf(const ImportedModel& model) {
    if (!model.looks || model.looks->notes.size() != 1) return "not one note";
    EXPECT_TRUE(model.looks->images.empty());
    EXPECT_EQ(model.looks->materials[model.mesh.corners[0][0].material].base_map.image, kNoImage);
    return model.looks->notes[0];
}

/// As files are that were made where the two are the same.
TEST_F(ImportLooks, PicturesAreFoundWhateverTheCaseOfTheirNames) {
    write("cube.mtl", "newmtl skin\nKd 1 0 0\nmap_Kd Textures\\SKIN.PNG\n");
    const auto file = write("cube.obj", test::cubeObj("cube.mtl"));
    const auto png = test::pngOf(2, 2, test::fourTexels());
    write("Skin.png", png);
    EXPECT_TRUE(importModel(file).looks->notes.empty());
    std::filesystem::remove(file.parent_path() / "Skin.png");
    EXPECT_EQ(noteOf(importModel(file)),
              "the texture 'Textures\\SKIN.PNG' is missing: a plain colour instead");
    std::filesystem::create_directory(file.parent_path() / "textures");
    write("textures/skin.png", png);
    EXPECT_TRUE(importModel(file).looks->notes.empty());
}

TEST_F(ImportLooks, PicturesThatAreMissingDamagedOrTooLargeAreNamed) {
    write("cube.mtl", "newmtl skin\nKd 1 0 0\nmap_Kd skin.png\n");
    const auto file = write("cube.obj", test::cubeObj("cube.mtl"));
    EXPECT_EQ(noteOf(importModel(file)), "the texture 'skin.png' is missing: a plain colour instead");
    write("skin.png", "no picture at all");
    EXPECT_THAT(noteOf(importModel(file)), HasSubstr("'skin.png' is damaged, or neither PNG, JPEG nor TGA"));
    std::string png = test::pngOf(2, 2, test::fourTexels());
    write("skin.png", png.substr(0, png.size() / 2));
    EXPECT_THAT(noteOf(importModel(file)), HasSubstr("'skin.png' is damaged"));
    png[18] = 0x50;  // 20,482 px wide, in the header
    write("skin.png", png);
    EXPECT_THAT(noteOf(importModel(file)), HasSubstr("20482 x 2 px, more than 16384 along a side"));
}

TEST_F(ImportLooks, WhatIsRepairedKeepsThemAndWhatIsRemeshedTakesTheNearest) {
    TriangleMesh cube = test::makeCube(1);
    auto looks = std::make_shared<ModelLooks>();
    looks->materials.resize(cube.triangles.size());
    for (size_t t = 0; t < cube.triangles.size(); ++t)
        for (CornerAttributes& corner : cube.corners[t]) {
            corner.material = static_cast<uint32_t>(t);
            corner.colour = 0xff000000u | static_cast<uint32_t>(20 * t);
        }
    MeshPlacement placement;
    placement.repair.mode = RepairMode::kRemesh;
    const auto solid = makeSolidMesh(cube, "cube.obj", placement, looks);
    EXPECT_EQ(modelLooks(*solid), looks.get());
    const auto body = fillWithParticles(*solid, {.particles = 20});
    EXPECT_EQ(body->looks, looks);
    ASSERT_EQ(body->geometry.looks.size(), body->geometry.mesh_triangles.size());
    EXPECT_GT(body->geometry.looks.size(), 1000u);
    std::set<uint32_t> seen;
    for (const TriangleLook& look : body->geometry.looks) {
        ASSERT_LT(look.material, 12u);
        for (const uint32_t colour : look.colour) EXPECT_EQ(colour, 0xff000000u | 20 * look.material);
        seen.insert(look.material);
    }
    EXPECT_EQ(seen.size(), 12u);

    cube.triangles.pop_back();
    cube.corners.pop_back();
    const auto capped = makeSolidMesh(cube, "open.obj", {}, looks);
    const auto filled = fillWithParticles(*capped, {.particles = 20});
    EXPECT_EQ(filled->geometry.looks.size(), 12u);
    for (const TriangleLook& look : filled->geometry.looks)
        EXPECT_LT(look.material, 11u) << "the cap looks as what is beside it";
}

}  // namespace
}  // namespace demolish
