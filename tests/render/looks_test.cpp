// SPDX-License-Identifier: Apache-2.0
// The outside as model files say: the right colour at the right place, however the body was cut, and alike by
// both ways of drawing.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "app/session/scene_looks.h"
#include "sim_cuda/api/model_file.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::engine::test {
namespace {

constexpr uint32_t kPx = 64;

using FileMaterial = demolish::LookMaterial;  // as files have it, not as the engine
using Texel = std::array<uint8_t, 4>;

LookImage painted(const std::function<Texel(uint32_t x, uint32_t y)>& texel) {
    LookImage image{kPx, kPx, {}};
    for (uint32_t y = 0; y < kPx; ++y)
        for (uint32_t x = 0; x < kPx; ++x) {
            const Texel t = texel(x, y);
            image.texels.insert(image.texels.end(), t.begin(), t.end());
        }
    return image;
}

/// Red and green above blue and white.
LookImage fourFields() {
    return painted([](uint32_t x, uint32_t y) -> Texel {
        const bool right = x >= kPx / 2, low = y >= kPx / 2;
        return {uint8_t(right == low ? 255 : 0), uint8_t(right ? 255 : 0), uint8_t(low ? 255 : 0), 255};
    });
}

/// 1 m along each side, standing on y = 0. Seen from +x, u runs to the right and v upwards.
TriangleMesh cube() {
    TriangleMesh mesh = demolish::test::makeCube(1);
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            Double3& p = mesh.positions[mesh.triangles[t][k]];
            mesh.corners[t][k].uv = {float(0.5 - 0.9 * p.z), float(0.5 + 0.9 * p.y)};  // off the seams
            mesh.corners[t][k].material = 0;
        }
    return mesh;
}

std::shared_ptr<ModelLooks> looksOf(const FileMaterial& material, std::vector<LookImage> images) {
    auto looks = std::make_shared<ModelLooks>();
    looks->materials = {material};
    looks->images = std::move(images);
    return looks;
}

Scene sceneOf(FractureMeshData data, const SceneSetup& setup) {
    const auto looks = sceneLooks(setup);
    data.looks = &*looks;
    Scene scene;
    scene.mesh = std::make_unique<FractureMesh>(data);
    scene.view.show_cracks = false;
    return scene;
}

std::shared_ptr<const BreakableBody> cut(const TriangleMesh& mesh, std::shared_ptr<const ModelLooks> looks,
                                         uint32_t cells) {
    return fillWithParticles(*makeSolidMesh(mesh, "test.obj", {}, std::move(looks)), {.particles = cells});
}

Scene cutScene(const TriangleMesh& mesh, std::shared_ptr<const ModelLooks> looks, uint32_t cells = 20) {
    SceneSetup setup;
    const auto body = cut(mesh, std::move(looks), cells);
    setup.bodies.emplace_back().body = body;
    FractureMeshData data;
    data.exterior_vertices = std::as_bytes(std::span(body->geometry.exterior));
    data.exterior_indices = body->geometry.exterior_indices;
    data.particle_count = body->particles.size();
    return sceneOf(data, setup);
}

/// The triangles as the file has them.
Scene uncutScene(const TriangleMesh& mesh, std::shared_ptr<const ModelLooks> looks) {
    SceneSetup setup;
    const auto body = cut(mesh, std::move(looks), 2);
    setup.bodies.emplace_back().body = body;
    std::vector<SurfaceVertex> vertices;
    std::vector<uint32_t> indices;
    for (uint32_t t = 0; t < body->geometry.mesh_triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            const MeshTriangle& triangle = body->geometry.mesh_triangles[t];
            indices.push_back(static_cast<uint32_t>(vertices.size()));
            vertices.push_back({triangle.corner[k], triangle.normal[k], t, 0});
        }
    FractureMeshData data;
    data.exterior_vertices = std::as_bytes(std::span(vertices));
    data.exterior_indices = indices;
    data.particle_count = 2;
    return sceneOf(data, setup);
}

/// Straight at the side x = 0.5, and nothing else.
void lookAtSide(FrameView& view) {
    view.width = view.height = 128;
    view.camera.eye = {2.5f, 0.5f, 0};
    view.camera.target = {0.5f, 0.5f, 0};
    view.camera.field_of_view = 2 * std::atan(0.5f / 2);
}

void lookFromCorner(FrameView& view) {
    view.width = 320;
    view.height = 240;
    view.camera.eye = {2.0f, 1.6f, -1.2f};
    view.camera.target = {0, 0.5f, 0};
}

class LooksTest : public GlTest {};

float linear(const Image& image, float u, float v, size_t channel) {
    const int x = int(u * float(image.width)), y = int((1 - v) * float(image.height));
    return decoded(image.at(x, y)[channel]);
}

TEST_F(LooksTest, APictureLiesTheRightWayUpAndInItsColours) {
    FileMaterial material;
    material.base_map.image = 0;
    material.base_colour[1] = 0.5f;
    Scene scene = cutScene(cube(), looksOf(material, {fourFields()}));
    putIntoFurnace(scene.view, glm::vec3(0.8f));
    lookAtSide(scene.view);
    for (const auto quality : {RenderQuality::kDraft, RenderQuality::kFull}) {
        scene.view.quality = quality;
        const Image image = drawPicture(renderer(), scene);
        const struct {
            float u, v, red, green, blue;
        } fields[] = {{0.25f, 0.75f, 0.8f, 0, 0},
                      {0.75f, 0.75f, 0, 0.4f, 0},
                      {0.25f, 0.25f, 0, 0, 0.8f},
                      {0.75f, 0.25f, 0.8f, 0.4f, 0.8f}};
        for (const auto& field : fields) {
            EXPECT_NEAR(linear(image, field.u, field.v, 0), field.red, 0.06f) << field.u << ' ' << field.v;
            EXPECT_NEAR(linear(image, field.u, field.v, 1), field.green, 0.06f) << field.u << ' ' << field.v;
            EXPECT_NEAR(linear(image, field.u, field.v, 2), field.blue, 0.06f) << field.u << ' ' << field.v;
        }
    }
}

TEST_F(LooksTest, WhatTheFileSaysNothingOfIsOfTheBodysMaterial) {
    FileMaterial red, unsaid;
    for (FileMaterial* both : {&red, &unsaid}) both->base_colour[1] = 0;
    unsaid.says_nothing = 1;
    Scene as_file = cutScene(cube(), looksOf(red, {})), own = cutScene(cube(), looksOf(unsaid, {}));
    for (Scene* scene : {&as_file, &own}) lookAtSide(scene->view);
    EXPECT_GT(differingPixels(drawPicture(renderer(), as_file), drawPicture(renderer(), own), 20), 500u);
}

TEST_F(LooksTest, ColoursAtTheVerticesRunBetweenThem) {
    TriangleMesh mesh = cube();
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k)  // black below, white above
            mesh.corners[t][k].colour = mesh.positions[mesh.triangles[t][k]].y > 0 ? kWhite : 0xff000000u;
    Scene scene = cutScene(mesh, looksOf({}, {}));
    putIntoFurnace(scene.view, glm::vec3(0.8f));
    lookAtSide(scene.view);
    const Image image = drawPicture(renderer(), scene);
    for (const float v : {0.25f, 0.5f, 0.75f}) EXPECT_NEAR(linear(image, 0.5f, v, 1), 0.8f * v, 0.05f);
}

FileMaterial everything() {
    FileMaterial material;
    material.base_map.image = 0;
    material.normal_map.image = 1;
    material.roughness_map = {0, 1};
    material.metallic_map = {0, 2};
    material.occlusion_map.image = 0;
    material.emission_map.image = 0;
    material.metallic = 1;
    material.emission[2] = 0.3f;
    return material;
}

/// Bumps in rows.
LookImage bumps() {
    return painted([](uint32_t x, uint32_t y) -> Texel {
        const double s = std::sin(0.4 * x), t = std::cos(0.3 * y);
        return {uint8_t(127.5 + 60 * s), uint8_t(127.5 + 60 * t), 220, 255};
    });
}

TriangleMesh lookedBall() {
    TriangleMesh ball = demolish::test::makeSphere(0.5, 3);
    for (auto& corners : ball.corners)
        for (CornerAttributes& corner : corners) corner.material = 0;
    return ball;
}

TEST_F(LooksTest, AWholeCutBodyLooksAsItsUncutMesh) {
    const TriangleMesh ball = lookedBall();
    const auto looks = looksOf(everything(), {fourFields(), bumps()});
    Scene cut_scene = cutScene(ball, looks, 300), uncut = uncutScene(ball, looks);
    for (Scene* scene : {&cut_scene, &uncut}) {
        lookFromCorner(scene->view);
        scene->view.samples = 1;
    }
    const Image image = drawPicture(renderer(), cut_scene);
    EXPECT_LE(differingPixels(image, drawPicture(renderer(), uncut), 6), 320u * 240u / 200);
    uncut.view.model_looks = false;
    EXPECT_GT(differingPixels(image, drawPicture(renderer(), uncut), 30), 5000u) << "the looks are seen";
}

TEST_F(LooksTest, BothWaysOfDrawingAgree) {
    Scene scene = cutScene(lookedBall(), looksOf(everything(), {fourFields(), bumps()}), 100);
    lookFromCorner(scene.view);
    scene.view.samples = 1;
    scene.view.rasteriser = Rasteriser::kDraw;
    const Image drawn = drawPicture(renderer(), scene);
    scene.view.rasteriser = Rasteriser::kCompute;
    const Image computed = drawPicture(renderer(), scene);
    EXPECT_EQ(renderer().refusal(), "");
    // llvmpipe takes one mip map for four lanes, whatever the others of them show.
    EXPECT_LE(differingPixels(drawn, computed, 8), 320u * 240u / 50);
}

TEST_F(LooksTest, ANormalMapBendsTheLight) {
    FileMaterial material;
    material.normal_map.image = 0;
    // Leaning to +u, which is -z.
    Scene scene = cutScene(cube(), looksOf(material, {painted([](uint32_t, uint32_t) -> Texel {
                                               return {217, 128, 218, 255};
                                           })}));
    putIntoFurnace(scene.view, glm::vec3(0));
    lookAtSide(scene.view);
    const auto brightness = [&](glm::vec3 travels) {
        scene.view.lighting.sun_direction = travels;
        scene.view.lighting.sun_colour = glm::vec3(0.5f);
        return linear(drawPicture(renderer(), scene), 0.5f, 0.5f, 1);
    };
    const float along = brightness(glm::normalize(glm::vec3(-1, 0, 1)));
    const float against = brightness(glm::normalize(glm::vec3(-1, 0, -1)));
    EXPECT_GT(along, 0.3f);
    EXPECT_LT(against, 0.1f);
}

TEST_F(LooksTest, WhatShinesDoesSoInTheDark) {
    FileMaterial material;
    material.emission[0] = 0.5f;
    Scene scene = cutScene(cube(), looksOf(material, {}));
    putIntoFurnace(scene.view, glm::vec3(0));
    lookAtSide(scene.view);
    for (const auto quality : {RenderQuality::kDraft, RenderQuality::kFull}) {
        scene.view.quality = quality;
        const Image image = drawPicture(renderer(), scene);
        EXPECT_NEAR(linear(image, 0.5f, 0.5f, 0), 0.5f, 0.03f);
        EXPECT_EQ(linear(image, 0.5f, 0.5f, 1), 0);
    }
}

TEST_F(LooksTest, WhatIsBlendedLetsThroughAsMuchAsItIsNotOpaque) {
    const auto greenAt = [&](float opacity) {
        FileMaterial material;
        material.base_colour[1] = material.base_colour[2] = 0;
        material.base_colour[3] = opacity;
        material.alpha_cutoff = demolish::kBlends;
        Scene scene = cutScene(cube(), looksOf(material, {}));
        putIntoFurnace(scene.view, glm::vec3(0.8f));
        lookAtSide(scene.view);
        const Image image = drawPicture(renderer(), scene);
        double green = 0;
        for (int y = 32; y < 96; ++y)
            for (int x = 32; x < 96; ++x) green += decoded(image.at(x, y)[1]);
        return green / (64 * 64);
    };
    const double gloss = greenAt(1);
    EXPECT_LT(gloss, 0.1) << "red, but for what mirrors";
    for (const float opacity : {0.25f, 0.6f})
        EXPECT_NEAR(greenAt(opacity), opacity * gloss + 0.8 * (1 - opacity), 0.03) << "the furnace behind it";
}

/// Root of the mean square of what the bytes of these rows and columns differ by from their mean.
double spreadOf(const Image& image, int first, int end) {
    double sum = 0, squares = 0;
    for (int y = first; y < end; ++y)
        for (int x = first; x < end; ++x) {
            const double value = image.at(x, y)[1];
            sum += value;
            squares += value * value;
        }
    const double count = (end - first) * (end - first), mean = sum / count;
    return std::sqrt(squares / count - mean * mean);
}

/// Root of the mean square of what its pixels differ by from their mean, in the middle.
double grainOf(const std::vector<Image>& averaged) {
    double sum = 0, squares = 0;
    for (int y = 32; y < 96; ++y)
        for (int x = 32; x < 96; ++x) {
            double value = 0;
            for (const Image& image : averaged) value += decoded(image.at(x, y)[1]);
            value /= static_cast<double>(averaged.size());
            sum += value;
            squares += value * value;
        }
    const double mean = sum / (64 * 64);
    return std::sqrt(squares / (64 * 64) - mean * mean);
}

Scene blendedCube(float opacity) {
    FileMaterial material;
    material.base_colour[1] = material.base_colour[2] = 0;
    material.base_colour[3] = opacity;
    material.alpha_cutoff = demolish::kBlends;
    Scene scene = cutScene(cube(), looksOf(material, {}));
    putIntoFurnace(scene.view, glm::vec3(0.8f));
    lookAtSide(scene.view);
    return scene;
}

/// The same picture, each square of 4 x 4 pixels as one.
Image coarser(const Image& image) {
    Image small{image.width / 4, image.height / 4, {}};
    small.pixels.resize(size_t{4} * static_cast<size_t>(small.width * small.height));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            double sum = 0;
            for (int k = 0; k < 16; ++k) sum += image.at(4 * x + k % 4, 4 * y + k / 4)[1];
            small.pixels[size_t{4} * static_cast<size_t>(y * small.width + x) + 1] =
                static_cast<uint8_t>(sum / 16 + 0.5);
        }
    return small;
}

TEST_F(LooksTest, WhatIsBlendedHasNoGrainsInASinglePicture) {
    for (const float opacity : {0.4f, 0.55f}) {
        const Image image = drawPicture(renderer(), blendedCube(opacity));
        const double of_pixels = spreadOf(image, 32, 96), of_squares = spreadOf(coarser(image), 9, 23);
        EXPECT_LT(of_squares, 0.18 * of_pixels) << "a quarter where no pixel knows of the others";
    }
}

TEST_F(LooksTest, PicturesThatAFilmAveragesSmoothWhatIsBlended) {
    Scene scene = blendedCube(0.4f);
    std::vector<Image> pictures;
    for (int k = 0; k < 8; ++k) {
        scene.view.noise_turn = static_cast<float>(k) / 8;
        pictures.push_back(drawPicture(renderer(), scene));
    }
    const double grain = grainOf({pictures[0]});
    EXPECT_GT(grain, 0.05);
    EXPECT_LT(grainOf(pictures), 0.2 * grain);
}

TEST_F(LooksTest, APictureMayLieOnTheSecondUvs) {
    TriangleMesh mesh = cube();
    for (auto& corners : mesh.corners)
        for (CornerAttributes& corner : corners) {
            corner.second_uv = corner.uv;
            corner.uv = {0.25f, 0.75f};  // all red
        }
    FileMaterial material;
    material.base_map.image = 0;
    for (const uint8_t set : {0, 1}) {
        material.base_map.uv_set = set;
        Scene scene = cutScene(mesh, looksOf(material, {fourFields()}));
        putIntoFurnace(scene.view, glm::vec3(0.8f));
        lookAtSide(scene.view);
        scene.view.quality = RenderQuality::kDraft;
        for (const auto rasteriser : {Rasteriser::kDraw, Rasteriser::kCompute}) {
            scene.view.rasteriser = rasteriser;
            const Image image = drawPicture(renderer(), scene);
            EXPECT_NEAR(linear(image, 0.3f, 0.7f, 0), 0.8f, 0.06f) << int(set);
            EXPECT_NEAR(linear(image, 0.7f, 0.7f, 1), set == 1 ? 0.8f : 0, 0.06f) << int(set);
            EXPECT_NEAR(linear(image, 0.3f, 0.3f, 2), set == 1 ? 0.8f : 0, 0.06f) << int(set);
        }
    }
}

TEST_F(LooksTest, WhatIsCutOutIsNotThere) {
    FileMaterial material;
    material.base_map.image = 0;
    material.alpha_cutoff = 0.5f;
    const LookImage left = painted([](uint32_t x, uint32_t) -> Texel {
        return {255, 0, 0, uint8_t(x < kPx / 2 ? 255 : 0)};
    });
    for (const bool both_sides : {false, true}) {
        material.is_double_sided = both_sides ? 1 : 0;
        Scene scene = cutScene(cube(), looksOf(material, {left}));
        putIntoFurnace(scene.view, glm::vec3(0.8f));
        scene.view.lighting.surroundings.reset();
        lookAtSide(scene.view);
        const Image image = drawPicture(renderer(), scene);
        EXPECT_GT(linear(image, 0.25f, 0.5f, 0), 4 * linear(image, 0.25f, 0.5f, 2));
        EXPECT_LT(linear(image, 0.75f, 0.5f, 0), 2 * linear(image, 0.75f, 0.5f, 2)) << "the sky behind it";
    }
}

}  // namespace
}  // namespace demolish::engine::test
