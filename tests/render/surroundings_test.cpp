// SPDX-License-Identifier: Apache-2.0
// Light from all around, and what the camera makes of it: a furnace, tone curves, floors, alpha.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/surroundings/surroundings.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

using SurroundingsTest = GlTest;

int encoded(float linear) {
    const float v = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
    return static_cast<int>(std::lround(255 * v));
}

/// Mean of what the display shines with where `ids` shows the body.
float meanOfBody(const Image& picture, const std::vector<uint32_t>& ids) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < ids.size(); ++i)
        if (isBody(ids[i])) {
            sum += static_cast<double>(decoded(picture.pixels[4 * i + 1]));
            ++count;
        }
    return static_cast<float>(sum / static_cast<double>(count));
}

TEST_F(SurroundingsTest, ABallInAFurnaceShinesWithItsAlbedo) {
    constexpr float kRadiance = 0.6f;
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft})
        for (const float albedo : {0.25f, 0.6f, 1.0f}) {
            Scene scene = greyBall(albedo, 1);
            putIntoFurnace(scene.view, glm::vec3(kRadiance));
            scene.view.quality = quality;
            const Image picture = drawPicture(renderer(), scene);
            const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
            // A few hundredths of the light are mirrored before the albedo takes its share.
            const float mean = meanOfBody(picture, ids);
            EXPECT_GT(mean, 0.95f * albedo * kRadiance);
            EXPECT_LT(mean, (albedo + 0.08f * (1 - albedo)) * kRadiance * 1.02f);
        }
}

TEST_F(SurroundingsTest, TheDisplayShowsWhatTheCurveSays) {
    for (const ToneCurve curve : {ToneCurve::kFilm, ToneCurve::kAgx, ToneCurve::kNeutral, ToneCurve::kNone})
        for (const float radiance : {0.02f, 0.18f, 0.7f, 3.0f}) {
            Scene scene = makeScene("empty_floor");
            putIntoFurnace(scene.view, glm::vec3(radiance));
            scene.view.lighting.tone = curve;
            scene.view.lighting.exposure = 0.5f;
            scene.view.quality = RenderQuality::kDraft;
            const Image picture = drawPicture(renderer(), scene);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(picture.at(200, 100)[channel], encoded(toneOfGrey(curve, 0.5f * radiance)), 2);
        }
}

TEST_F(SurroundingsTest, WhiteBalanceGreysTheLightItIsSetTo) {
    Scene scene = makeScene("empty_floor");
    putIntoFurnace(scene.view, glm::vec3(0.4f));
    scene.view.quality = RenderQuality::kDraft;
    scene.view.lighting.temperature = 3200;
    const Image blue = drawPicture(renderer(), scene);
    EXPECT_GT(blue.at(9, 9)[2], blue.at(9, 9)[0] + 60);
    const glm::vec3 lamp = 0.4f / whiteBalance(3200);
    scene.view.lighting.surroundings = makeSurroundings(RadiancePicture(32, 16, lamp), std::nullopt);
    const Image grey = drawPicture(renderer(), scene);
    EXPECT_NEAR(grey.at(9, 9)[0], grey.at(9, 9)[2], 2);
}

/// The picture's own directions: red comes from +x, green from above.
TEST_F(SurroundingsTest, TheBackdropStandsWhereItsLightComesFrom) {
    RadiancePicture picture(64, 32, glm::vec3(0));
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec3 d = picture.direction(x, y);
            picture.at(x, y) = glm::vec3(d.x > 0.5f, d.y > 0.5f, d.z > 0.5f);
        }
    Scene scene = makeScene("empty_floor");
    putIntoFurnace(scene.view, glm::vec3(0));
    scene.view.lighting.surroundings = makeSurroundings(picture, std::nullopt);
    scene.view.quality = RenderQuality::kDraft;
    const glm::vec3 ways[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int channel = 0; channel < 3; ++channel) {
        scene.view.camera.eye = glm::vec3(0, 1, 0);
        scene.view.camera.target = scene.view.camera.eye + ways[channel];
        const Image seen = drawPicture(renderer(), scene);
        for (int k = 0; k < 3; ++k) EXPECT_EQ(seen.at(240, 135)[k], k == channel ? 255 : 0);
    }
}

TEST_F(SurroundingsTest, AlphaIsOneInTheBodyAndZeroWhereNothingIs) {
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
        Scene scene = wholeBlock();
        scene.view.quality = quality;
        scene.view.transparent = true;
        scene.view.lighting.floor = FloorMaterial::kNone;
        const Image picture = drawPicture(renderer(), scene);
        const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
        size_t between = 0;
        for (size_t i = 0; i < ids.size(); ++i) {
            const int alpha = picture.pixels[4 * i + 3];
            if (alpha > 0 && alpha < 255)
                ++between;
            else
                ASSERT_EQ(alpha, isBody(ids[i]) ? 255 : 0);
        }
        EXPECT_LT(between, 1500u) << "only along the outline";
    }
}

TEST_F(SurroundingsTest, AShadowFloorHoldsOnlyTheShadow) {
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
        Scene scene = wholeBlock();
        scene.view.quality = quality;
        scene.view.transparent = true;
        scene.view.lighting.floor = FloorMaterial::kShadow;
        const Image picture = drawPicture(renderer(), scene);
        const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
        size_t shadow = 0, clear = 0;
        const auto width = static_cast<size_t>(picture.width);
        for (size_t i = width + 1; i + width + 1 < ids.size(); ++i) {
            bool only_floor = true;
            for (const size_t near : {i - width - 1, i - width, i - width + 1, i - 1, i, i + 1, i + width - 1,
                                      i + width, i + width + 1})
                only_floor = only_floor && ids[near] == kFloorId;
            if (!only_floor) continue;
            const int alpha = picture.pixels[4 * i + 3];
            shadow += alpha > 90;
            clear += alpha < 6;
            if (alpha > 90 && alpha < 250) {
                ASSERT_LT(picture.pixels[4 * i], 20);
            }
        }
        EXPECT_GT(shadow, 800u);
        EXPECT_GT(clear, 40000u);
    }
}

/// Without transparency the shadow lies on the surroundings, which are as they are elsewhere.
TEST_F(SurroundingsTest, AShadowFloorShowsTheBackdropWhereTheSunReachesIt) {
    Scene scene = wholeBlock();
    scene.view.quality = RenderQuality::kDraft;
    scene.view.lighting.floor = FloorMaterial::kShadow;
    const Image with = drawPicture(renderer(), scene);
    scene.mesh.reset();
    scene.view.lighting.floor = FloorMaterial::kNone;
    const Image without = drawPicture(renderer(), scene);
    size_t darker = 0, same = 0;
    for (int y = 0; y < with.height; ++y)
        for (int x = 0; x < with.width; ++x) {
            const int loss = without.at(x, y)[1] - with.at(x, y)[1];
            darker += loss > 25;
            same += std::abs(loss) <= 2;
        }
    EXPECT_GT(darker, 800u);
    EXPECT_GT(same, 60000u);
}

TEST_F(SurroundingsTest, EveryFloorIsDrawnAlikeByBothWaysAndUnlikeTheOthers) {
    std::vector<Image> pictures;
    for (const FloorMaterial floor : {FloorMaterial::kChecker, FloorMaterial::kConcrete,
                                      FloorMaterial::kPlanks, FloorMaterial::kGrid, FloorMaterial::kSweep}) {
        Scene scene = makeScene("empty_floor");
        scene.view.lighting.floor = floor;
        const Image full = drawPicture(renderer(), scene);
        scene.view.quality = RenderQuality::kDraft;
        EXPECT_LT(differingPixels(full, drawPicture(renderer(), scene), 24), 2000u);
        for (const Image& other : pictures) EXPECT_GT(differingPixels(full, other, 6), 2000u);
        pictures.push_back(full);
    }
}

/// By how much a white floor outshines a black one `below` pixels under the middle of the picture.
float floorContrast(Renderer& renderer, Scene& scene, int below) {
    float light[2];
    for (const int white : {0, 1}) {
        scene.view.lighting.floor_colour = glm::vec3(static_cast<float>(white));
        const Image picture = drawPicture(renderer, scene);
        light[white] = decoded(picture.at(scene.view.width / 2, scene.view.height / 2 + below)[1]);
    }
    return light[1] - light[0];
}

/// Air takes nothing from what one looks at, however far the camera goes back to see all of it, and the floor
/// is gone before it ends.
TEST_F(SurroundingsTest, AirIsClearAboutTheSceneAndHidesTheEndOfTheFloor) {
    Scene scene = makeScene("empty_floor");
    putIntoFurnace(scene.view, glm::vec3(0.6f));
    scene.view.lighting.floor = FloorMaterial::kChecker;
    scene.view.quality = RenderQuality::kDraft;
    const float radius = scene.view.scene_radius;
    engine::Camera& camera = scene.view.camera;
    camera.target = {0.5f, 0, 0.5f};  // the middle of a tile
    const auto contrastFrom = [&](float radii) {
        camera.eye = camera.target + radii * radius * glm::normalize(glm::vec3(0.3f, 0.5f, 0.8f));
        return floorContrast(renderer(), scene, 0);
    };
    const float near = contrastFrom(1.5f);
    EXPECT_GT(near, 0.4f);
    EXPECT_GT(contrastFrom(10), 0.92f * near);
    camera.eye = {0, radius, 0};
    camera.target = {0, radius, -1};
    EXPECT_LT(floorContrast(renderer(), scene, 3), 0.02f * near);
}

/// What the picture has below the horizon, here without red, shows neither above a floor's end nor in the
/// haze that it fades into; without a floor it is seen.
TEST_F(SurroundingsTest, TheGroundOfAPictureDoesNotShowAboveAFloor) {
    RadiancePicture picture(256, 128, glm::vec3(0.6f));
    for (int y = 64; y < 128; ++y)
        for (int x = 0; x < 256; ++x) picture.at(x, y) = {0, 0.6f, 0};
    Scene scene = makeScene("empty_floor");
    putIntoFurnace(scene.view, glm::vec3(0.6f));
    scene.view.lighting.surroundings = makeSurroundings(picture, std::nullopt);
    scene.view.lighting.floor = FloorMaterial::kConcrete;
    scene.view.camera.eye = {0, scene.view.scene_radius, 0};
    scene.view.camera.target = {0, scene.view.scene_radius, -1};
    const auto leastRed = [&](bool floor) {
        scene.view.show_floor = floor;
        const Image shown = drawPicture(renderer(), scene);
        float least = 1;
        for (int row = -6; row <= 6; ++row)
            least = std::min(least, decoded(shown.at(shown.width / 2, shown.height / 2 + row)[0]));
        return least;
    };
    EXPECT_GT(leastRed(true), 0.55f);
    EXPECT_LT(leastRed(false), 0.05f);
}

/// Stone that nobody has polished keeps its colour towards a low sun.
TEST_F(SurroundingsTest, StoneFloorsHardlyMirrorTheSun) {
    for (const FloorMaterial stone : {FloorMaterial::kChecker, FloorMaterial::kConcrete}) {
        Scene scene = makeScene("empty_floor");
        putIntoFurnace(scene.view, glm::vec3(0));
        scene.view.lighting.floor = stone;
        scene.view.lighting.floor_colour = glm::vec3(0.5f);
        scene.view.lighting.sun_direction = {0, -0.4f, 0.9f};
        scene.view.lighting.sun_colour = glm::vec3(0.5f);
        const float radius = scene.view.scene_radius;
        const auto lightSeen = [&](float side) {
            scene.view.camera.target = {0.5f, 0, 0.5f};  // the middle of a tile
            scene.view.camera.eye = scene.view.camera.target + radius * glm::vec3(0, 0.4f, side * 0.9f);
            const Image picture = drawPicture(renderer(), scene);
            return decoded(picture.at(picture.width / 2, picture.height / 2)[1]);
        };
        const float towards = lightSeen(1), away = lightSeen(-1);
        EXPECT_LT(towards, 1.8f * away);
    }
}

/// The sweep has no horizon: no jump from a row of the picture to the next.
TEST_F(SurroundingsTest, TheSweepHasNoHorizon) {
    Scene scene = makeScene("empty_floor");
    scene.view.lighting.floor = FloorMaterial::kSweep;
    scene.view.camera.target.y = 1.1f;
    const Image picture = drawPicture(renderer(), scene);
    for (int y = 1; y < picture.height; ++y)
        EXPECT_LE(std::abs(picture.at(240, y)[1] - picture.at(240, y - 1)[1]), 3) << y;
}

}  // namespace
}  // namespace demolish::engine::test
