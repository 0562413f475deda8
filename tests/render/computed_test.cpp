// SPDX-License-Identifier: Apache-2.0
// The body found in compute passes looks as it looks drawn, but for rounding at edges.
#include <filesystem>
#include <fstream>

#include <glm/gtc/constants.hpp>
#include <sstream>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class Computed : public GlTest {
  protected:
    static void expectSameLook(Scene& scene) { expectSameLook(scene, renderer()); }

    /// At an edge several triangles share a pixel: one that covers no middle of a pixel is shaded where it
    /// covers it, drawn it is shaded beyond its end.
    static void expectSameLook(Scene& scene, Renderer& computing) {
        scene.view.rasteriser = Rasteriser::kDraw;
        const Image drawn = drawPicture(renderer(), scene);
        scene.view.rasteriser = Rasteriser::kCompute;
        const Image computed = drawPicture(computing, scene);
        EXPECT_EQ(computing.refusal(), "");
        const auto pixels = static_cast<double>(drawn.width * drawn.height);
        EXPECT_LE(static_cast<double>(differingPixels(drawn, computed, 5)), 0.005 * pixels);
        EXPECT_LE(static_cast<double>(differingPixels(drawn, computed, 32)), 0.001 * pixels);
    }
};

Scene small(const std::string& name) {
    Scene scene = makeScene(name);
    scene.view.width = 320;
    scene.view.height = 180;
    return scene;
}

void turn(Camera& camera, float angle) {
    const glm::vec3 out = camera.eye - camera.target;
    const float c = std::cos(angle), s = std::sin(angle);
    camera.eye = camera.target + glm::vec3(c * out.x + s * out.z, out.y, c * out.z - s * out.x);
}

TEST_F(Computed, CracksAreTheSame) {
    Scene scene = small("cracked_block");
    expectSameLook(scene);
}

TEST_F(Computed, PiecesAndProjectilesAreTheSameFromEverySide) {
    Scene scene = small("broken_ball");
    for (int side = 0; side < 2; ++side) {
        SCOPED_TRACE(side);
        expectSameLook(scene);
        turn(scene.view.camera, 2.4f);
    }
}

TEST_F(Computed, GritAndDustAreTheSame) {
    Scene scene = small("dusty_block");
    expectSameLook(scene);
    scene.view.samples = 1;
    expectSameLook(scene);
}

TEST_F(Computed, AGrainBeforeTheEyeIsTheSame) {
    Scene scene = small("whole_block");
    const glm::vec3 eye = scene.view.camera.eye, ahead = glm::normalize(scene.view.camera.target - eye);
    writeEffects(*scene.mesh, {{eye + 0.3f * ahead, 0.16f, {0, 0x7fff0000u}, 5}}, {});
    expectSameLook(scene);
    const Image with = drawPicture(renderer(), scene);
    scene.mesh->showEffects(false, false);
    EXPECT_GT(differingPixels(with, drawPicture(renderer(), scene), 20), 2500u);
}

TEST_F(Computed, CollidersAndTheirShadowsAreTheSame) {
    Scene scene = small("broken_ball");
    ColliderDraw box;
    box.position = {-0.55f, 0.2f, 0.7f};
    box.rotation = glm::angleAxis(0.4f, glm::normalize(glm::vec3(0.2f, 1, 0.1f)));
    box.half_size = {0.3f, 0.2f, 0.25f};
    ColliderDraw plane = box;
    plane.shape = ColliderShape::kPlane;
    plane.position = {-0.2f, 0.5f, -1.2f};
    plane.half_size = {0.8f, 0.6f, 0.05f};
    ColliderDraw rod = box;
    rod.shape = ColliderShape::kCapsule;
    rod.position = {0.7f, 0.2f, 0.5f};
    rod.half_size = {0.1f, 0.1f, 0.35f};
    ColliderDraw ball = rod;
    ball.shape = ColliderShape::kSphere;
    ball.position = {0.1f, 0.15f, 1.0f};
    ball.half_size = glm::vec3(0.15f);
    scene.view.colliders = {box, plane, rod, ball};
    expectSameLook(scene);
    scene.view.rasteriser = Rasteriser::kCompute;
    const Image with = drawPicture(renderer(), scene);
    scene.view.colliders.clear();
    EXPECT_GT(differingPixels(with, drawPicture(renderer(), scene), 20), 500u);
}

/// The first of those pixels, with both colours.
std::string whereTheyDiffer(const Image& a, const Image& b, int more_than) {
    std::ostringstream text;
    size_t told = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width && told < 8; ++x) {
            int most = 0;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.at(x, y)[c] - b.at(x, y)[c]));
            if (most <= more_than) continue;
            ++told;
            text << " (" << x << ", " << y << "):";
            for (const Image* image : {&a, &b})
                for (int c = 0; c < 3; ++c) text << ' ' << int(image->at(x, y)[c]);
        }
    return text.str();
}

TEST_F(Computed, OfOneSampleEveryPixelIsTheSame) {
    Scene scene = small("broken_ball");
    scene.view.samples = 1;
    scene.view.rasteriser = Rasteriser::kDraw;
    const Image drawn = drawPicture(renderer(), scene);
    scene.view.rasteriser = Rasteriser::kCompute;
    const Image computed = drawPicture(renderer(), scene);
    EXPECT_LE(differingPixels(drawn, computed, 3), 3u) << whereTheyDiffer(drawn, computed, 3);
}

TEST_F(Computed, SmallTrianglesFromAfar) {
    Scene scene = small("broken_ball");
    const glm::vec3 out = scene.view.camera.eye - scene.view.camera.target;
    scene.view.camera.eye = scene.view.camera.target + 6.0f * out;
    expectSameLook(scene);
}

TEST_F(Computed, TheNearPlaneCutsPieces) {
    Scene scene = small("broken_block");
    Camera& camera = scene.view.camera;
    camera.near_plane = 0.9f * glm::length(camera.eye - camera.target);
    expectSameLook(scene);
}

TEST_F(Computed, TooManyLargeTrianglesForTheirMemory) {
    Renderer poor(shaderFolder(), 10);
    Scene scene = small("broken_block");
    expectSameLook(scene, poor);
}

TEST_F(Computed, TheSameFrameIsTheSamePicture) {
    Scene scene = small("broken_block");
    scene.view.rasteriser = Rasteriser::kCompute;
    const Image first = drawPicture(renderer(), scene);
    EXPECT_TRUE(first.pixels == drawPicture(renderer(), scene).pixels);
}

/// Light empties what it has read, cracks at the silhouette among it.
TEST_F(Computed, NothingIsLeftOfThePictureBefore) {
    Scene cracked = small("cracked_block"), broken = small("broken_ball");
    cracked.view.rasteriser = broken.view.rasteriser = Rasteriser::kCompute;
    turn(cracked.view.camera, 0.7f);
    Renderer fresh(shaderFolder());
    const Image expected = drawPicture(fresh, broken);
    EXPECT_FALSE(drawPicture(renderer(), cracked).pixels == expected.pixels);
    EXPECT_TRUE(drawPicture(renderer(), broken).pixels == expected.pixels);
    cracked.view.width = 192;
    drawPicture(renderer(), cracked);
    EXPECT_TRUE(drawPicture(renderer(), broken).pixels == expected.pixels) << "after another size";
}

Scene ofGlass(const std::string& name) {
    Scene scene = small(name);
    scene.view.look.refraction_index = 1.5f;
    scene.view.look.frost = 0.1f;
    scene.view.look.absorption[0] = 2;
    return scene;
}

TEST_F(Computed, FacesOfGlassAreTheSameFromEverySide) {
    for (const char* name : {"whole_block", "broken_block", "broken_ball"}) {
        Scene scene = ofGlass(name);
        for (int side = 0; side < 2; ++side) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(side));
            scene.view.samples = side == 0 ? 4 : 1;
            expectSameLook(scene);
            turn(scene.view.camera, 2.4f);
        }
    }
}

TEST_F(Computed, GlassFromAfarAndCutByTheNearPlane) {
    Scene scene = ofGlass("broken_block");
    Camera& camera = scene.view.camera;
    const glm::vec3 out = camera.eye - camera.target;
    camera.eye = camera.target + 5.0f * out;
    expectSameLook(scene);
    camera.eye = camera.target + out;
    camera.near_plane = 0.9f * glm::length(out);
    expectSameLook(scene);
}

TEST_F(Computed, TooManyLargeFacesOfGlassForTheirMemory) {
    Renderer poor(shaderFolder(), 10);
    Scene scene = ofGlass("broken_block");
    expectSameLook(scene, poor);
}

TEST_F(Computed, GlassBesideAnOpaqueBody) {
    Scene scene = ofGlass("broken_block");
    giveHalvesTwoLooks(scene, 0.3f);
    SurfaceLook stone = scene.view.look;
    stone.refraction_index = 1;
    scene.view.more_looks = {stone};
    expectSameLook(scene);
    const Image both = drawPicture(renderer(), scene);
    scene.view.more_looks[0].refraction_index = 1.5f;
    EXPECT_GT(differingPixels(both, drawPicture(renderer(), scene), 20), 500u);
}

/// The walk empties what it has read.
TEST_F(Computed, NothingIsLeftOfTheGlassBefore) {
    Scene whole = ofGlass("whole_block"), broken = ofGlass("broken_ball");
    whole.view.rasteriser = broken.view.rasteriser = Rasteriser::kCompute;
    Renderer fresh(shaderFolder());
    const Image expected = drawPicture(fresh, broken);
    EXPECT_FALSE(drawPicture(renderer(), whole).pixels == expected.pixels);
    EXPECT_TRUE(drawPicture(renderer(), broken).pixels == expected.pixels);
    EXPECT_TRUE(drawPicture(renderer(), broken).pixels == expected.pixels) << "drawn again";
}

TEST_F(Computed, DraftsAreDrawn) {
    Scene scene = small("broken_block_draft");
    scene.view.rasteriser = Rasteriser::kDraw;
    const Image drawn = drawPicture(renderer(), scene);
    scene.view.rasteriser = Rasteriser::kCompute;
    EXPECT_TRUE(drawn.pixels == drawPicture(renderer(), scene).pixels);
}

TEST_F(Computed, WhereTheDriverRefusesAShaderThePictureIsDrawn) {
    const auto folder = std::filesystem::temp_directory_path() / "demolish_refused_shader";
    std::filesystem::remove_all(folder);
    std::filesystem::copy(shaderFolder(), folder, std::filesystem::copy_options::recursive);
    std::ofstream(folder / "raster_triangles.comp") << "#version 450\nrefused\n";
    Renderer refused(folder);
    Scene scene = small("broken_ball");
    scene.view.rasteriser = Rasteriser::kDraw;
    const Image drawn = drawPicture(renderer(), scene);
    scene.view.rasteriser = Rasteriser::kCompute;
    EXPECT_EQ(differingPixels(drawn, drawPicture(refused, scene), 0), 0u);
    EXPECT_NE(refused.refusal().find("raster_triangles.comp"), std::string::npos) << refused.refusal();
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace demolish::engine::test
