// SPDX-License-Identifier: Apache-2.0
// Facts of grit and dust that hold on every driver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class EffectsPicture : public GlTest, public testing::WithParamInterface<RenderQuality> {
  protected:
    Scene scene() const {
        Scene whole = wholeBlock();
        whole.view.quality = GetParam();
        return whole;
    }
    static Image picture(const Scene& scene) { return drawPicture(renderer(), scene); }
};

/// Before the block, `share` of the way from the eye to it.
glm::vec3 towardsBlock(const Scene& scene, float share) {
    return glm::mix(scene.view.camera.eye, scene.view.camera.target, share);
}

struct Colour {
    int red, green, blue;
    int sum() const { return red + green + blue; }
};
Colour middleOf(const Image& image) {
    const uint8_t* pixel = image.at(image.width / 2, image.height / 2);
    return {pixel[0], pixel[1], pixel[2]};
}

TEST_P(EffectsPicture, WithoutAnyThePictureIsTheSameToTheLastBit) {
    Scene with = scene();
    const Image none = picture(with);
    writeEffects(*with.mesh, {}, {});
    EXPECT_EQ(picture(with).pixels, none.pixels);
    writeEffects(*with.mesh, {{towardsBlock(with, 0.6f), 0.05f, {0, 0x7fff0000u}, 3}},
                 {{towardsBlock(with, 0.6f), 0.3f, 1, 0.3f, 1}});
    EXPECT_GT(differingPixels(picture(with), none, 10), 500u);
    with.view.show_effects = false;
    EXPECT_EQ(picture(with).pixels, none.pixels);
}

TEST_P(EffectsPicture, AGrainHasTheBrokenMaterialAndAShadow) {
    for (const Rasteriser rasteriser : {Rasteriser::kDraw, Rasteriser::kCompute}) {
        Scene with = scene();
        with.view.rasteriser = rasteriser;
        with.mesh.reset();
        with.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 0.001f});
        with.mesh = std::make_unique<FractureMesh>(with.body->makeMesh());
        const Image none = picture(with);
        const float(&inside)[3] = with.view.look.interior_colour;
        ASSERT_GT(inside[0], 1.5f * inside[2]);  // a warm colour, unlike the floor's
        // A seed without a coat on any face. So large that its shadow is, too.
        writeEffects(*with.mesh, {{{0, 0.42f, 0}, 0.6f, {0, 0x7fff0000u}, 1}}, {});
        const Image one = picture(with);
        const Colour middle = middleOf(one);
        EXPECT_GT(middle.red, middle.blue + 10);
        size_t darker = 0;  // of the floor: as cool as the sky, and less than it was
        for (int y = one.height / 2; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x) {
                const uint8_t *now = one.at(x, y), *before = none.at(x, y);
                darker += now[1] + 25 < before[1] && now[2] >= now[0];
            }
        EXPECT_GT(darker, 300u) << "by computing: " << (rasteriser == Rasteriser::kCompute);
    }
}

TEST_P(EffectsPicture, AGrainBehindTheBlockIsNotSeen) {
    Scene with = scene();
    const Image none = picture(with);
    writeEffects(*with.mesh, {{{-0.1f, 0.4f, -0.2f}, 0.1f, {0, 0x7fff0000u}, 3}}, {});
    EXPECT_LT(differingPixels(picture(with), none, 6), 20u);
}

TEST_P(EffectsPicture, DustHidesAsMuchAsItsDepthSaysAndNothingBeforeIt) {
    Scene with = scene();
    with.view.look.dust_colour[0] = with.view.look.dust_colour[1] = with.view.look.dust_colour[2] = 0.9f;
    const Image none = picture(with);
    const glm::vec3 before = towardsBlock(with, 0.65f);
    const int clear = middleOf(none).sum();
    int last = clear;
    for (const float depth : {0.15f, 0.4f, 1.0f}) {  // the block's front is darker than this dust
        writeEffects(*with.mesh, {}, {{before, 0.25f, depth, 0.2f, 9}});
        const int now = middleOf(picture(with)).sum();
        EXPECT_GT(now, last + 5) << depth;
        last = now;
    }
    writeEffects(*with.mesh, {}, {{{-0.3f, 0.4f, -0.4f}, 0.1f, 3, 0.2f, 9}});
    EXPECT_NEAR(middleOf(picture(with)).sum(), clear, 6);
}

TEST_P(EffectsPicture, PuffsNeedNoOrder) {
    Scene with = scene();
    const glm::vec3 near = towardsBlock(with, 0.55f), far = towardsBlock(with, 0.7f);
    writeEffects(*with.mesh, {}, {{near, 0.2f, 0.5f, 0.2f, 1}, {far, 0.2f, 0.8f, 0.9f, 2}});
    const Image one = picture(with);
    writeEffects(*with.mesh, {}, {{far, 0.2f, 0.8f, 0.9f, 2}, {near, 0.2f, 0.5f, 0.2f, 1}});
    EXPECT_EQ(differingPixels(one, picture(with), 2), 0u);
}

TEST_P(EffectsPicture, SmallGrainsAreThinnedOutAndNotLost) {
    // As many grains, ever smaller, of one colour: what they cover shrinks with their area, down to a share
    // of a pixel each.
    Scene with = scene();
    with.view.show_floor = false;
    with.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 0.001f});
    with.mesh = std::make_unique<FractureMesh>(with.body->makeMesh());
    const Image none = picture(with);
    const auto covered = [&](float size) {
        std::vector<GrainDraw> grains;
        for (uint32_t k = 0; k < 4000; ++k) {
            const float x = static_cast<float>(k % 64) / 64 - 0.5f,
                        y = static_cast<float>(k / 64) / 64 - 0.5f;
            grains.push_back({{1.2f * x, 0.42f + 1.2f * y, 0}, size, {0, 0x7fff0000u}, 31 * k});
        }
        writeEffects(*with.mesh, grains, {});
        const Image now = picture(with);
        double sum = 0;
        for (size_t i = 0; i < now.pixels.size(); ++i) sum += std::abs(now.pixels[i] - none.pixels[i]);
        return sum;
    };
    const double large = covered(0.008f), small = covered(0.004f), tiny = covered(0.002f);
    EXPECT_GT(large / small, 2.2);
    EXPECT_LT(large / small, 7);
    EXPECT_GT(small / tiny, 2.2);
    EXPECT_LT(small / tiny, 7);
}

/// A white puff before nothing is as bright as what is round it says, and as opaque as it is deep.
TEST_P(EffectsPicture, DustIsLitByWhatSurroundsItAndHasAlpha) {
    Scene with = scene();
    with.view.transparent = true;
    with.view.look.dust_colour[0] = with.view.look.dust_colour[1] = with.view.look.dust_colour[2] = 1;
    with.mesh.reset();
    with.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1e-4f});
    with.mesh = std::make_unique<FractureMesh>(with.body->makeMesh());
    for (const float light : {0.2f, 0.4f}) {
        putIntoFurnace(with.view, glm::vec3(light, light, 2 * light));
        int last = 0;
        for (const float depth : {0.2f, 0.8f, 3.0f}) {
            writeEffects(*with.mesh, {}, {{with.view.camera.target, 0.3f, depth, 0.05f, 9}});
            const Image now = picture(with);
            const uint8_t* pixel = now.at(now.width / 2, now.height / 2);
            EXPECT_GT(pixel[3], last + 15) << depth;
            last = pixel[3];
            EXPECT_NEAR(decoded(pixel[0]), light, 0.2f * light) << depth;
            EXPECT_NEAR(decoded(pixel[2]), 2 * light, 0.4f * light) << depth;
        }
        EXPECT_EQ(picture(with).at(5, 5)[3], 0);
    }
}

/// Alpha anywhere beside what is quite clear.
int mostBesideNothing(const Image& image) {
    int most = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 2; x < image.width; ++x) {
            const int left = image.at(x - 2, y)[3], right = image.at(x, y)[3];
            if (std::min(left, right) == 0) most = std::max(most, std::max(left, right));
        }
    return most;
}

/// Wherever its lumps are: a single puff thins out to nothing, and is worn in its middle too. Or it is a
/// disc.
TEST_P(EffectsPicture, APuffHasNeitherARimNorAPlateau) {
    Scene with = scene();
    with.view.transparent = true;
    putIntoFurnace(with.view, glm::vec3(0.5f));
    with.mesh.reset();
    with.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1e-4f});
    with.mesh = std::make_unique<FractureMesh>(with.body->makeMesh());
    int least = 255, most = 0;  // in the middle
    for (uint32_t k = 0; k < 12; ++k) {
        with.view.camera.eye.x += 0.37f;
        with.view.camera.target.x += 0.37f;
        writeEffects(*with.mesh, {}, {{with.view.camera.target, 0.4f, 1, 0.05f, 0x9e3779b9u * k}});
        const Image one = picture(with);
        const int middle = one.at(one.width / 2, one.height / 2)[3];
        EXPECT_GT(middle, 100) << k;
        EXPECT_LT(mostBesideNothing(one), 34) << k;
        least = std::min(least, middle);
        most = std::max(most, middle);
    }
    EXPECT_GT(most, least + 20);
}

/// From near a grain is a bit of stone, whose faces are rough; flat ones are of one colour each.
TEST_P(EffectsPicture, NearGrainsAreRough) {
    Scene with = scene();
    const Image none = picture(with);
    writeEffects(*with.mesh, {{towardsBlock(with, 0.3f), 0.25f, {0, 0x7fff0000u}, 5}}, {});
    const Image one = picture(with);
    const auto sumAt = [](const Image& image, int x, int y) {
        const uint8_t* pixel = image.at(x, y);
        return pixel[0] + pixel[1] + pixel[2];
    };
    size_t pairs = 0, steps = 0;
    for (int y = 0; y < one.height; ++y)
        for (int x = 0; x + 1 < one.width; ++x) {
            if (std::abs(sumAt(one, x, y) - sumAt(none, x, y)) < 15 ||
                std::abs(sumAt(one, x + 1, y) - sumAt(none, x + 1, y)) < 15)
                continue;
            ++pairs;
            steps += std::abs(sumAt(one, x, y) - sumAt(one, x + 1, y)) >= 4 ? 1 : 0;
        }
    ASSERT_GT(pairs, 1000u);
    EXPECT_GT(static_cast<double>(steps) / static_cast<double>(pairs), 0.4);
}

/// Where a puff's middle hides the sun from the floor, exp(-depth) of its light is left.
TEST_P(EffectsPicture, DustShadesTheFloorAsMuchAsItsDepthSays) {
    if (GetParam() == RenderQuality::kDraft) GTEST_SKIP() << "drafts have no shadow of dust";
    Scene with = scene();
    with.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1e-4f});
    with.mesh = std::make_unique<FractureMesh>(with.body->makeMesh());
    const FloorMaterial floor = with.view.lighting.floor;
    putIntoFurnace(with.view, glm::vec3(0));
    with.view.lighting.floor = floor;
    with.view.lighting.sun_colour = glm::vec3(5);
    with.view.camera.eye = {0.6f, 2.5f, -0.6f};
    with.view.camera.target = {0.1f, 0, 0.1f};
    const glm::vec3 to_sun = -glm::normalize(with.view.lighting.sun_direction);
    const auto lit = [&](const std::vector<PuffDraw>& puffs) {
        writeEffects(*with.mesh, {}, puffs);
        const Image image = picture(with);
        return decoded(image.at(image.width / 2, image.height / 2)[1]);
    };
    const float bare = lit({});
    ASSERT_GT(bare, 0.1f);
    for (const float depth : {0.3f, 1.0f, 2.0f}) {
        const glm::vec3 middle = with.view.camera.target + to_sun;
        EXPECT_NEAR(lit({{middle, 0.3f, depth, 0.2f, 9}}) / bare, std::exp(-depth), 0.03f) << depth;
        // Two of half the depth, one behind the other.
        const PuffDraw near{middle, 0.3f, 0.5f * depth, 0.2f, 9},
            far{middle + 0.2f * to_sun, 0.3f, 0.5f * depth, 0.2f, 5};
        EXPECT_NEAR(lit({near, far}) / bare, std::exp(-depth), 0.03f) << depth;
    }
    EXPECT_NEAR(lit({{with.view.camera.target + glm::vec3(0, 0, 1.2f) + to_sun, 0.3f, 2, 0.2f, 9}}), bare,
                0.01f);
}

/// Dust is added up in fewer pixels than the picture has. What stands before it keeps its outline all the
/// same: right beside it the dust behind is as thick as where nothing stands.
TEST_P(EffectsPicture, DustGoesOnRightBesideWhatStandsBeforeIt) {
    if (GetParam() == RenderQuality::kDraft) GTEST_SKIP() << "drafts blend what is round a pixel";
    for (const Rasteriser rasteriser : {Rasteriser::kDraw, Rasteriser::kCompute}) {
        Scene with = scene(), without = scene();
        without.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1e-4f});
        without.mesh = std::make_unique<FractureMesh>(without.body->makeMesh());
        const glm::vec3 behind = towardsBlock(with, 1.6f);
        const auto drawn = [&](Scene& scene, float depth) {
            scene.view.rasteriser = rasteriser;
            scene.view.show_floor = false;
            scene.view.transparent = true;
            putIntoFurnace(scene.view, glm::vec3(0.5f));
            writeEffects(*scene.mesh, {}, {{behind, 2, depth, 0.3f, 9}});
            return picture(scene);
        };
        const Image block = drawn(with, 0), dusty = drawn(with, 2), dust = drawn(without, 2);
        const auto isClear = [&](int x, int y) { return block.at(x, y)[3] == 0; };
        size_t beside = 0, thinner = 0;
        for (int y = 1; y + 1 < dust.height; ++y)
            for (int x = 1; x + 1 < dust.width; ++x) {
                if (!isClear(x, y) ||
                    (isClear(x - 1, y) && isClear(x + 1, y) && isClear(x, y - 1) && isClear(x, y + 1)))
                    continue;
                ++beside;
                thinner += dusty.at(x, y)[3] + 20 < dust.at(x, y)[3] ? 1 : 0;
            }
        ASSERT_GT(beside, 200u);
        // 0.23 where texels are blended whatever they show; a few have no texel round them that shows
        // nothing.
        EXPECT_LT(static_cast<double>(thinner), 0.08 * static_cast<double>(beside));
    }
}

INSTANTIATE_TEST_SUITE_P(Qualities, EffectsPicture,
                         testing::Values(RenderQuality::kFull, RenderQuality::kDraft), [](const auto& param) {
                             return param.param == RenderQuality::kFull ? "Full" : "Draft";
                         });

}  // namespace
}  // namespace demolish::engine::test
