// SPDX-License-Identifier: Apache-2.0
// Facts of transparent bodies that hold on every driver.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/surroundings/surroundings.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

struct Way {
    const char* name;
    RenderQuality quality;
    Rasteriser rasteriser;
};

void PrintTo(const Way& way, std::ostream* out) {
    *out << way.name;
}

class GlassTest : public GlTest, public testing::WithParamInterface<Way> {
  protected:
    /// A block of clear glass.
    static Scene block(float size = 1) {
        Scene scene;
        scene.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = size});
        scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
        scene.view = wholeBlock().view;
        choose(scene);
        scene.view.width = 240;
        scene.view.height = 136;
        scene.view.look.refraction_index = 1.5f;
        scene.view.look.frost = 0;
        return scene;
    }
    static void choose(Scene& scene) {
        scene.view.quality = GetParam().quality;
        scene.view.rasteriser = GetParam().rasteriser;
    }
    static Image picture(const Scene& scene) { return drawPicture(renderer(), scene); }
};

glm::vec3 colourAt(const Image& image, int x, int y) {
    const uint8_t* pixel = image.at(x, y);
    return {decoded(pixel[0]), decoded(pixel[1]), decoded(pixel[2])};
}

/// Even light from everywhere is bent and mirrored into even light.
TEST_P(GlassTest, ClearGlassVanishesInAFurnace) {
    Scene scene = block();
    putIntoFurnace(scene.view, glm::vec3(0.5f));
    const Image image = picture(scene);
    for (int y = 4; y < image.height; y += 8)
        for (int x = 4; x < image.width; x += 8)
            EXPECT_NEAR(colourAt(image, x, y).g, 0.5f, 0.03f) << x << ' ' << y;
}

TEST_P(GlassTest, AbsorbsByThickness) {
    for (const float size : {0.2f, 0.4f, 0.8f}) {
        Scene scene = block(size);
        putIntoFurnace(scene.view, glm::vec3(0.5f));
        scene.view.look.refraction_index = 1.01f;
        scene.view.look.absorption[0] = 3;
        scene.view.look.absorption[1] = 1;
        scene.view.camera.eye = {0, size / 2, 5};
        scene.view.camera.target = {0, size / 2, 0};
        scene.view.camera.field_of_view = 0.05f;
        const Image image = picture(scene);
        const glm::vec3 seen = colourAt(image, image.width / 2, image.height / 2);
        EXPECT_NEAR(seen.r, 0.5f * std::exp(-3 * size), 0.02f) << size;
        EXPECT_NEAR(seen.g, 0.5f * std::exp(-size), 0.02f) << size;
        EXPECT_NEAR(seen.b, 0.5f, 0.02f) << size;
    }
}

/// The longest straight way through the block leaves exp(-sqrt(3)) of red; what is mirrored inside has a
/// longer one, and is darker than that.
TEST_P(GlassTest, DarkensWhatItMirrorsInside) {
    Scene scene = block();
    putIntoFurnace(scene.view, glm::vec3(0.5f));
    const auto dark = [&](float index) {
        scene.view.look.refraction_index = index;
        const Image image = picture(scene);
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) count += colourAt(image, x, y).r < 0.06f;
        return count;
    };
    scene.view.look.absorption[0] = 1;
    EXPECT_EQ(dark(1.01f), 0);
    EXPECT_GT(dark(1.5f), 100);
}

TEST_P(GlassTest, ShowsWhatStandsBehind) {
    Scene scene = block();
    const glm::vec3 behind = glm::mix(scene.view.camera.eye, scene.view.camera.target, 1.5f);
    const auto changed = [&](bool transparent) {
        scene.view.look.refraction_index = transparent ? 1.05f : 1;
        scene.spheres.clear();
        const Image without = picture(scene);
        scene.spheres = {{{behind.x, behind.y + 0.15f, behind.z}, 0.15f}};
        const Image with = picture(scene);
        int count = 0;  // where the middle of the block is seen
        for (int y = 48; y < 88; ++y)
            for (int x = 100; x < 140; ++x) count += std::abs(with.at(x, y)[1] - without.at(x, y)[1]) > 10;
        return count;
    };
    EXPECT_EQ(changed(false), 0);
    EXPECT_GT(changed(true), 60);
    scene.view.look.refraction_index = 1.5f;
    ColliderDraw box;
    box.position = {0.2f, 0.5f, -1.2f};
    box.half_size = {0.4f, 0.4f, 0.1f};
    scene.spheres.clear();
    const Image without = picture(scene);
    scene.view.colliders = {box};
    EXPECT_GT(differingPixels(picture(scene), without, 6), 300u);
}

/// A thing before it hides it.
TEST_P(GlassTest, IsHiddenByWhatStandsBefore) {
    Scene scene = block();
    const glm::vec3 before = glm::mix(scene.view.camera.eye, scene.view.camera.target, 0.5f);
    scene.spheres = {{{before.x, before.y, before.z}, 0.3f}};
    const Image with = picture(scene);
    scene.mesh.reset();
    const Image alone = picture(scene);
    for (const int x : {110, 120, 130}) EXPECT_NEAR(with.at(x, 68)[1], alone.at(x, 68)[1], 12);
}

TEST_P(GlassTest, NeedsNoOrderOfItsTriangles) {
    Scene scene = brokenBlock();
    choose(scene);
    scene.view.look.refraction_index = 1.5f;
    const Image one = picture(scene);
    for (const StreamId id : {StreamId::kExteriorIndices, StreamId::kInteriorIndices}) {
        gl::Buffer& stream = scene.mesh->stream(id);
        std::vector<uint32_t> indices(stream.size() / 4);
        stream.download(std::as_writable_bytes(std::span(indices)));
        // The stream of broken faces holds no more than it was made for: zeros at its end draw nothing.
        const size_t triangles = indices.size() / 3;
        for (size_t k = 0; k < triangles / 2; ++k)
            for (size_t c = 0; c < 3; ++c)
                std::swap(indices[3 * k + c], indices[3 * (triangles - 1 - k) + c]);
        stream.upload(std::as_bytes(std::span(indices)));
    }
    EXPECT_LT(differingPixels(picture(scene), one, 3), 40u);
}

TEST_P(GlassTest, ItsShadowIsLighterAndTinted) {
    Scene scene = block();
    scene.view.look.absorption[0] = 4;
    scene.view.look.absorption[1] = scene.view.look.absorption[2] = 0.2f;
    const Image glass = picture(scene);
    const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
    scene.view.look.refraction_index = 1;
    const Image opaque = picture(scene);
    scene.mesh.reset();
    const Image none = picture(scene);
    glm::vec3 light[3]{};
    for (size_t i = 0; i < ids.size(); ++i) {
        const int x = static_cast<int>(i) % glass.width, y = static_cast<int>(i) / glass.width;
        if (ids[i] != kFloorId || colourAt(opaque, x, y).g > 0.6f * colourAt(none, x, y).g) continue;
        light[0] += colourAt(opaque, x, y);
        light[1] += colourAt(glass, x, y);
        light[2] += colourAt(none, x, y);
    }
    EXPECT_GT(light[2].g, 100.0f);  // there is a shadow
    EXPECT_GT(light[1].g, 1.3f * light[0].g);
    EXPECT_LT(light[1].g, 1.02f * light[2].g);
    EXPECT_LT(light[1].r / light[1].b, 0.8f * light[2].r / light[2].b);
}

/// What bends next to nothing takes from the floor's light only what its faces mirror. On a floor as
/// dark as this two of 255 levels are 3 % of the light.
TEST_P(GlassTest, TheFloorGetsAllThatIsNotBent) {
    if (GetParam().quality == RenderQuality::kDraft) GTEST_SKIP() << "drafts have a guess";
    Scene scene = block();
    scene.view.look.refraction_index = 1.0002f;
    const Image glass = picture(scene);
    const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
    scene.mesh.reset();
    const Image none = picture(scene);
    int darker = 0;
    for (size_t i = 0; i < ids.size(); ++i) {
        const int x = static_cast<int>(i) % glass.width, y = static_cast<int>(i) / glass.width;
        if (ids[i] != kFloorId) continue;
        const float share = colourAt(glass, x, y).g / colourAt(none, x, y).g;
        EXPECT_LT(share, 1.04f) << x << ' ' << y;
        darker += share < 0.75f;
    }
    EXPECT_LT(darker, 60);  // beside the block, which shades the sky there
}

TEST_P(GlassTest, HasAlphaBetweenNothingAndAll) {
    Scene scene = block();
    scene.view.transparent = true;
    scene.view.lighting.floor = FloorMaterial::kNone;
    scene.view.look.absorption[0] = scene.view.look.absorption[1] = scene.view.look.absorption[2] = 0.5f;
    const Image image = picture(scene);
    EXPECT_EQ(image.at(3, 3)[3], 0);
    const int middle = image.at(image.width / 2, image.height / 2)[3];
    EXPECT_GT(middle, 40);
    EXPECT_LT(middle, 245);
}

TEST_P(GlassTest, FrostScatters) {
    Scene scene = brokenBlock();
    choose(scene);
    scene.view.look.refraction_index = 1.3f;
    scene.view.look.frost = 0;
    const Image clear = picture(scene);
    scene.view.look.frost = 0.6f;
    EXPECT_GT(differingPixels(picture(scene), clear, 12), 2000u);
}

/// Light of a sky that is the brighter the higher one looks.
float skyAt(float up) {
    return 0.5f + 0.4f * up;
}

void putUnderSky(FrameView& view) {
    putIntoFurnace(view, glm::vec3(0.5f));
    RadiancePicture sky(256, 128);
    for (int row = 0; row < sky.height; ++row)
        for (int column = 0; column < sky.width; ++column)
            sky.at(column, row) = glm::vec3(skyAt(sky.direction(column, row).y));
    view.lighting.surroundings = makeSurroundings(std::move(sky), std::nullopt);
}

/// A ball of glass shows what is behind it upside down: a parallel ray that meets it `h` radii above its
/// middle is bent twice by the same angle.
TEST_P(GlassTest, ABallTurnsThePictureUpsideDown) {
    Scene scene = block();
    scene.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .roundness = 1, .subdivisions = 32});
    scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
    putUnderSky(scene.view);
    scene.view.camera.eye = {0, 0.5f, 60};
    scene.view.camera.target = {0, 0.5f, 0};
    const float across = 1.2f;  // m, the picture's height
    scene.view.camera.field_of_view = 2 * std::atan(0.5f * across / 60);
    const Image image = picture(scene);
    for (const float h : {-0.8f, -0.6f, -0.4f, -0.2f, 0.2f, 0.4f, 0.6f, 0.8f}) {
        const float outside = std::asin(h), inside = std::asin(h / 1.5f);
        const float f =
            0.04f + 0.96f * std::pow(1 - std::cos(outside), 5.0f);  // mirrored by a face (Schlick)
        const float through = skyAt(-std::sin(2 * (outside - inside))),
                    mirrored = skyAt(std::sin(2 * outside));
        const float expected = (1 - f) * (1 - f) * through + f * mirrored + f * 0.5f;
        const int y = static_cast<int>((0.5f - 0.5f * h / across) * static_cast<float>(image.height));
        EXPECT_NEAR(colourAt(image, image.width / 2, y).g, expected, 0.05f) << h;
    }
}

/// A face that lies in the floor neither flickers nor lets the sky through.
TEST_P(GlassTest, StandsOnTheFloorAsJustAboveIt) {
    Scene scene = block();
    scene.view.look.absorption[0] = 1;
    const Image standing = picture(scene);
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; },
        [](uint32_t) {
            return Motion{.translation = {0, 0.002f, 0}};
        },
        [](uint32_t, uint32_t) { return false; });
    EXPECT_LT(differingPixels(standing, picture(scene), 10), 200u);
}

INSTANTIATE_TEST_SUITE_P(Ways, GlassTest,
                         testing::Values(Way{"Computed", RenderQuality::kFull, Rasteriser::kCompute},
                                         Way{"Drawn", RenderQuality::kFull, Rasteriser::kDraw},
                                         Way{"Draft", RenderQuality::kDraft, Rasteriser::kDraw}),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace demolish::engine::test
