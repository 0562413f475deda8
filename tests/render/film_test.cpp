// SPDX-License-Identifier: Apache-2.0
// Pictures averaged on a film: what rests is sharp, what moves is blurred as far as it moved, what is out of
// focus too.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/render/motion_between.h"
#include "engine/scene/lens.h"
#include "tests/render/developed.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

using FilmTest = GlTest;

constexpr float kFrame = 1.0f / 60;  // s

/// Seen from the front, with nothing behind it, so that alpha is the share of time in which a pixel was
/// covered.
Scene blockBeforeNothing() {
    Scene scene = wholeBlock();
    scene.view.quality = RenderQuality::kDraft;
    scene.view.transparent = true;
    scene.view.lighting.floor = FloorMaterial::kNone;
    scene.view.camera.eye = {0, 0.5f, 4};
    scene.view.camera.target = {0, 0.5f, 0.5f};
    scene.view.samples = 1;
    return scene;
}

void putAt(Scene& scene, glm::vec3 place, float turn = 0) {
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; },
        [&](uint32_t) {
            return Motion{.rotation = glm::angleAxis(turn, glm::vec3(0, 1, 0)), .translation = place};
        },
        [](uint32_t, uint32_t) { return false; });
}

Image exposed(Renderer& renderer, const Scene& scene, const Lens& lens, uint32_t pictures,
              const std::function<void(float)>& place = {}) {
    Film film(shaderFolder());
    film.begin(scene.view.width, scene.view.height);
    for (uint32_t i = 0; i < pictures; ++i) {
        if (place) place(pictureMoment(lens, i, pictures));
        renderer.draw(scene.mesh.get(), scene.spheres, pictureView(scene.view, lens, i, pictures),
                      film.framebuffer());
        film.add();
    }
    return developed(film, scene.view);
}

/// Pixels of a row whose alpha lies between the given shares.
int pixelsBetween(const Image& image, int y, float least, float most) {
    int count = 0;
    for (int x = 0; x < image.width; ++x) {
        const float alpha = static_cast<float>(image.at(x, y)[3]) / 255;
        count += alpha >= least && alpha <= most;
    }
    return count;
}

/// px on the block's front, half a metre before the middle.
float pixelsPerMetre(const Scene& scene) {
    const float aspect = static_cast<float>(scene.view.width) / static_cast<float>(scene.view.height);
    return 0.5f * static_cast<float>(scene.view.height) / scene.view.camera.halfHeight(aspect) / 3.5f;
}

TEST_F(FilmTest, OnePictureIsWhatTheRendererDraws) {
    for (const char* name : {"broken_block", "dusty_block"}) {
        Scene scene = makeScene(name);
        scene.view.samples = 1;
        const Image drawn = drawPicture(renderer(), scene);
        EXPECT_LT(differingPixels(exposed(renderer(), scene, {}, 1), drawn, 3), 300u) << name;
    }
}

TEST_F(FilmTest, ManyPicturesOfAStillSmoothItsEdgesOnly) {
    Scene scene = blockBeforeNothing();
    const Image still = exposed(renderer(), scene, {}, 16);
    EXPECT_LE(pixelsBetween(still, 135, 0.01f, 0.99f), 4);
    EXPECT_GT(pixelsBetween(still, 135, 1, 1), 60);
}

TEST_F(FilmTest, BlurIsAsLongAsTheWayDuringTheOpenShutter) {
    constexpr float kWay = 0.3f;  // m in a frame
    Scene scene = blockBeforeNothing();
    for (const float shutter : {0.5f, 1.0f}) {
        MotionBetween motion(shaderFolder());
        putAt(scene, {0, 0, 0});
        motion.remember(*scene.mesh);
        putAt(scene, {kWay, 0, 0});
        const Lens lens{.shutter = shutter, .samples = 32};
        const Image blurred = exposed(renderer(), scene, lens, 32,
                                      [&](float moment) { motion.place(*scene.mesh, moment, kFrame); });
        motion.restore(*scene.mesh);
        // Both the front and the back edge of the block sweep over this many pixels.
        const float swept = shutter * kWay * pixelsPerMetre(scene);
        EXPECT_NEAR(static_cast<float>(pixelsBetween(blurred, 135, 0.02f, 0.98f)), 2 * swept,
                    0.1f * swept + 5);
        const Image after = drawPicture(renderer(), scene);
        putAt(scene, {kWay, 0, 0});
        EXPECT_TRUE(after.pixels == drawPicture(renderer(), scene).pixels) << "the frame is as it was";
    }
}

TEST_F(FilmTest, BetweenTwoFramesABodyMovesRigidly) {
    Scene scene = blockBeforeNothing();
    MotionBetween motion(shaderFolder());
    // About an axis 2 m away: a quarter of the way is a quarter of the turn.
    const auto about = [](float turn) {
        const glm::vec3 pivot(2, 0, 0);
        return pivot - glm::angleAxis(turn, glm::vec3(0, 1, 0)) * pivot;
    };
    putAt(scene, about(0), 0);
    motion.remember(*scene.mesh);
    putAt(scene, about(0.4f), 0.4f);
    motion.place(*scene.mesh, 0.25f, kFrame);
    const Image between = drawPicture(renderer(), scene);
    motion.restore(*scene.mesh);
    putAt(scene, about(0.1f), 0.1f);
    EXPECT_LT(differingPixels(between, drawPicture(renderer(), scene), 24), 120u);
}

TEST_F(FilmTest, WhatBrokeOffComesFromWhereItsBodyWas) {
    Scene scene = brokenBlock();
    scene.view.quality = RenderQuality::kDraft;
    const auto whole = [&] {
        scene.body->write(
            *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; },
            [](uint32_t, uint32_t) { return false; });
    };
    const auto apart = [&](glm::vec3 way) {
        scene.body->write(
            *scene.mesh, [](uint32_t cell) { return cell; },
            [&](uint32_t slot) { return Motion{.translation = slot == 0 ? glm::vec3(0) : way}; },
            [](uint32_t, uint32_t) { return false; });
    };
    MotionBetween motion(shaderFolder());
    whole();
    motion.remember(*scene.mesh);
    apart({0.3f, 0.2f, 0});
    motion.place(*scene.mesh, 0.5f, kFrame);
    const Image between = drawPicture(renderer(), scene);
    motion.restore(*scene.mesh);
    apart({0.15f, 0.1f, 0});
    EXPECT_LT(differingPixels(between, drawPicture(renderer(), scene), 8), 50u);
}

TEST_F(FilmTest, GritAndDustMoveTooAndWhatIsNewStaysWhereItIs) {
    Scene scene = blockBeforeNothing();
    const auto at = [&](float x, uint32_t seed) {
        writeEffects(*scene.mesh, {{{x, 1.3f, 0}, 0.2f, {0, 0x7fff0000u}, seed}},
                     {{{-x, 1.4f, 0}, 0.2f, 2, 0.3f, seed}});
        return drawPicture(renderer(), scene);
    };
    const Image early = at(0.3f, 5), middle = at(0.45f, 5);
    MotionBetween motion(shaderFolder());
    at(0.3f, 5);
    motion.remember(*scene.mesh);
    const Image late = at(0.6f, 5);
    motion.place(*scene.mesh, 0.5f, kFrame);
    EXPECT_LT(differingPixels(drawPicture(renderer(), scene), middle, 3), 20u);
    EXPECT_GT(differingPixels(early, middle, 20), 300u);
    motion.restore(*scene.mesh);
    EXPECT_EQ(drawPicture(renderer(), scene).pixels, late.pixels);
    const Image other = at(0.6f, 6);
    motion.place(*scene.mesh, 0.5f, kFrame);
    EXPECT_EQ(drawPicture(renderer(), scene).pixels, other.pixels);
}

TEST_F(FilmTest, OnlyTheFocusIsSharp) {
    Scene scene = blockBeforeNothing();
    Lens lens{.aperture = 0.5f, .focus = 3.5f, .samples = 64};  // the front of the block
    const int sharp = pixelsBetween(exposed(renderer(), scene, lens, 64), 135, 0.05f, 0.95f);
    lens.focus = 1.2f;
    const int blurred = pixelsBetween(exposed(renderer(), scene, lens, 64), 135, 0.05f, 0.95f);
    EXPECT_LE(sharp, 4);
    // The circle of confusion at 3.5 m when 1.2 m are in focus, for both edges.
    const float circle =
        2 * apertureRadius(lens, scene.view.camera) * (3.5f / 1.2f - 1) * pixelsPerMetre(scene);
    EXPECT_NEAR(static_cast<float>(blurred), 2 * circle, circle) << "least and most alpha are left out";
    EXPECT_GT(blurred, sharp + 6);
}

}  // namespace
}  // namespace demolish::engine::test
