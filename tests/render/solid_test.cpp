// SPDX-License-Identifier: Apache-2.0
// What runs through a solid: the same on the outside and in the break, and alike by both ways of drawing.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

constexpr SolidTexture kTextures[] = {SolidTexture::kVeins,   SolidTexture::kLayers, SolidTexture::kCrystals,
                                      SolidTexture::kPebbles, SolidTexture::kBricks, SolidTexture::kGrains};

class SolidTest : public GlTest, public testing::WithParamInterface<SolidTexture> {};

/// White with a black pattern, by even light alone.
void showPattern(FrameView& view, SolidTexture texture) {
    putIntoFurnace(view, glm::vec3(0.8f));
    view.quality = RenderQuality::kDraft;
    view.show_cracks = false;
    view.look.noise_strength = 0;
    view.look.texture = texture;
    view.look.texture_size = texture == SolidTexture::kBricks   ? 0.8f
                             : texture == SolidTexture::kGrains ? 0.12f
                                                                : 0.25f;
    view.look.exterior_roughness = view.look.interior_roughness = 1;
    for (int k = 0; k < 3; ++k) {
        view.look.exterior_colour[k] = view.look.interior_colour[k] = 0.8f;
        view.look.texture_colour[k] = 0;
    }
}

/// Straight at the plane x = 0.5, of a square metre above the floor.
void lookAtPlane(FrameView& view) {
    view.width = view.height = 200;
    view.camera.eye = {20.5f, 0.5f, 0};
    view.camera.target = {0.5f, 0.5f, 0};
    view.camera.field_of_view = 2 * std::atan(0.5f / 20);
}

float greenAt(const Image& image, int x, int y) {
    return decoded(image.at(x, y)[1]);
}

bool isDark(const Image& image, int x, int y) {
    return greenAt(image, x, y) < 0.32f;
}

/// One on the pattern and the other beside it, and not both on its edge.
bool differ(float a, float b) {
    return std::min(a, b) < 0.28f && std::max(a, b) > 0.36f;
}

/// The same plane at rest, once as the outside of a small block and once as a broken face in a large one.
TEST_P(SolidTest, GoesOnFromTheOutsideIntoTheBreak) {
    Scene small, large;
    small.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1});
    large.body = std::make_unique<BlockBody>(BlockOptions{.cells = 4, .size = 2});
    for (Scene* scene : {&small, &large}) {
        scene->mesh = std::make_unique<FractureMesh>(scene->body->makeMesh());
        showPattern(scene->view, GetParam());
        scene->view.look.noise_scale = 0.05f;
        lookAtPlane(scene->view);
    }
    const auto beyond = [&](uint32_t cell) { return large.body->cellCentre(cell).x > 0.5f; };
    uint32_t first_beyond = 0, first_here = 0;
    while (!beyond(first_beyond)) ++first_beyond;
    while (beyond(first_here)) ++first_here;
    large.body->write(
        *large.mesh, [&](uint32_t cell) { return beyond(cell) ? first_beyond : first_here; },
        [&](uint32_t slot) {
            return Motion{.translation = slot == first_beyond ? glm::vec3(0, 0, 50) : glm::vec3(0)};
        },
        [](uint32_t, uint32_t) { return false; });
    const Image outside = drawPicture(renderer(), small), broken = drawPicture(renderer(), large);
    int dark = 0, other = 0, all = 0;
    for (int y = 6; y < 194; ++y)
        for (int x = 6; x < 194; ++x) {
            ++all;
            dark += isDark(outside, x, y);
            other += differ(greenAt(outside, x, y), greenAt(broken, x, y));
        }
    EXPECT_GT(dark, all / 150);
    EXPECT_LT(dark, all * 19 / 20);
    EXPECT_LT(other, all * 3 / 100);
}

using SolidsTest = GlTest;

/// An outside that hides the solid still shows what the mould of concrete left on it.
TEST_F(SolidsTest, ConcreteHasASkin) {
    const auto unevenness = [&](SolidTexture texture) {
        Scene scene;
        scene.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1});
        scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
        showPattern(scene.view, texture);
        scene.view.look.texture_outside = 0;
        lookAtPlane(scene.view);
        const Image image = drawPicture(renderer(), scene);
        float sum = 0, squares = 0, count = 0;
        for (int y = 6; y < 194; ++y)
            for (int x = 6; x < 194; ++x, ++count) {
                const float light = decoded(image.at(x, y)[1]);
                sum += light;
                squares += light * light;
            }
        return std::sqrt(squares / count - sum * sum / (count * count));
    };
    EXPECT_GT(unevenness(SolidTexture::kPebbles), 1.5f * unevenness(SolidTexture::kVeins));
}

TEST_F(SolidsTest, LookLikeThemselvesAndAlikeByBothWays) {
    Scene scene = makeScene("broken_ball");
    scene.spheres.clear();
    scene.view.width = 240;
    scene.view.height = 136;
    scene.view.look.texture_size = 0.2f;
    scene.view.look.coat = 0.02f;
    std::vector<Image> others;
    for (const SolidTexture texture : kTextures) {
        scene.view.look.texture = texture;
        scene.view.rasteriser = Rasteriser::kDraw;
        const Image drawn = drawPicture(renderer(), scene);
        scene.view.rasteriser = Rasteriser::kCompute;
        const bool of_noise = texture == SolidTexture::kVeins, of_cells = texture == SolidTexture::kPebbles;
        if (of_noise || of_cells) {
            EXPECT_LE(differingPixels(drawn, drawPicture(renderer(), scene), 12), 250u);
        }
        for (const Image& other : others) EXPECT_GT(differingPixels(drawn, other, 8), 150u);
        others.push_back(drawn);
    }
}

std::string nameOf(const testing::TestParamInfo<SolidTexture>& info) {
    const char* const names[] = {"None", "Veins", "Layers", "Crystals", "Pebbles", "Bricks", "Grains"};
    return names[static_cast<size_t>(info.param)];
}
INSTANTIATE_TEST_SUITE_P(Textures, SolidTest, testing::ValuesIn(kTextures), nameOf);

using CoatTest = GlTest;

/// Seen from the side, a broken face has the outside's colour as deep as the coat goes.
TEST_F(CoatTest, GoesAsDeepAsItIsThick) {
    for (const float coat : {0.0f, 0.05f, 0.1f}) {
        Scene scene;
        scene.body = std::make_unique<BlockBody>(BlockOptions{.cells = 4, .size = 2, .deep = 0.5f});
        scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
        showPattern(scene.view, SolidTexture::kNone);
        scene.view.look.coat = coat;
        for (float& channel : scene.view.look.exterior_colour) channel = 0.05f;
        lookAtPlane(scene.view);
        scene.view.camera.eye.y = scene.view.camera.target.y = 1.5f;
        const auto beyond = [&](uint32_t cell) { return scene.body->cellCentre(cell).x > 0.5f; };
        uint32_t first_beyond = 0;
        while (!beyond(first_beyond)) ++first_beyond;
        scene.body->write(
            *scene.mesh, [&](uint32_t cell) { return beyond(cell) ? first_beyond : 0; },
            [&](uint32_t slot) { return Motion{.translation = glm::vec3(0, 0, slot == 0 ? 0 : 50)}; },
            [](uint32_t, uint32_t) { return false; });
        const Image image = drawPicture(renderer(), scene);
        int dark = 0;  // down the middle, 200 px a metre; the block ends at the picture's upper edge
        for (int y = 0; y < 100; ++y) dark += isDark(image, 100, y);
        EXPECT_NEAR(dark, 200 * coat, 3) << coat;
    }
}

using LooksTest = GlTest;

/// Left red, right green, seen from the front; once the right is made of glass the floor is seen through it.
TEST_F(LooksTest, EachCellHasItsOwn) {
    Scene scene = makeScene("whole_block");
    giveHalvesTwoLooks(scene, 0);
    SurfaceLook red = scene.view.look, green = red;
    std::copy_n(std::array{0.6f, 0.02f, 0.02f}.data(), 3, red.exterior_colour);
    std::copy_n(std::array{0.02f, 0.6f, 0.02f}.data(), 3, green.exterior_colour);
    scene.view.look = red;
    scene.view.more_looks = {green};
    const auto count = [&](int strong, int weak) {
        const Image image = drawPicture(renderer(), scene);
        int pixels = 0;
        for (size_t p = 0; p < image.pixels.size(); p += 4)
            pixels += image.pixels[p + strong] > 2 * image.pixels[p + weak] + 20;
        return pixels;
    };
    const int reds = count(0, 1), greens = count(1, 0);
    EXPECT_GT(reds, 500);
    EXPECT_GT(greens, 500);
    scene.view.more_looks[0].refraction_index = 1.5f;
    EXPECT_GT(count(0, 1), reds / 2) << "what is not of glass stays";
    EXPECT_LT(count(1, 0), greens / 20);
}

/// Of one look, the left half a pale body's, the right half a dark one's.
TEST_F(LooksTest, BodiesOfOneLookDifferByItsVariation) {
    Scene scene = makeScene("whole_block");
    std::vector<uint32_t> looks;
    for (uint32_t cell = 0; cell < scene.body->cellCount(); ++cell)
        looks.push_back(cellLook(0, scene.body->cellCentre(cell).x > 0 ? -1.0f : 1.0f));
    scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh(looks));
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; },
        [](uint32_t, uint32_t) { return false; });
    putIntoFurnace(scene.view, glm::vec3(0.5f));
    const Image even = drawPicture(renderer(), scene);
    scene.view.look.variation = 0.3f;
    const Image varied = drawPicture(renderer(), scene);
    size_t paler = 0, darker = 0, others = 0;
    for (size_t p = 0; p < even.pixels.size(); p += 4) {
        if (even.pixels[p] == varied.pixels[p]) continue;
        // Of diffuse light 1.3 and 0.7 times as much; what the surface mirrors is the same.
        const float ratio = decoded(varied.pixels[p]) / decoded(even.pixels[p]);
        paler += ratio > 1.1f && ratio < 1.32f;
        darker += ratio > 0.68f && ratio < 0.9f;
        others += ratio <= 0.68f || ratio >= 1.32f;
    }
    EXPECT_GT(paler, 500u);
    EXPECT_GT(darker, 500u);
    EXPECT_LT(others, (paler + darker) / 50);
}

/// Or bricks of one model would look printed.
TEST_F(LooksTest, BodiesThatDifferAreCutFromOtherPlacesOfTheirSolid) {
    const auto drawnAs = [&](float paleness, SolidTexture texture) {
        Scene scene = makeScene("whole_block");
        const std::vector<uint32_t> looks(scene.body->cellCount(), cellLook(0, paleness));
        scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh(looks));
        scene.body->write(
            *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; },
            [](uint32_t, uint32_t) { return false; });
        putIntoFurnace(scene.view, glm::vec3(0.5f));
        scene.view.look.texture = texture;
        scene.view.look.variation = 0.001f;
        return drawPicture(renderer(), scene);
    };
    EXPECT_GT(
        differingPixels(drawnAs(0.3f, SolidTexture::kPebbles), drawnAs(-0.4f, SolidTexture::kPebbles), 8),
        2000u);
    EXPECT_LT(differingPixels(drawnAs(0.3f, SolidTexture::kNone), drawnAs(-0.4f, SolidTexture::kNone), 12),
              50u);
}

}  // namespace
}  // namespace demolish::engine::test
