// SPDX-License-Identifier: Apache-2.0
// Facts of sparks that hold on every driver: streaks as long as their way while the film is open.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <set>

#include "engine/render/motion_between.h"
#include "engine/scene/lens.h"
#include "tests/render/developed.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

constexpr float kFrame = 1.0f / 60, kLong = 1;  // s
constexpr float kSize = 3e-3f;                  // m
constexpr uint32_t kSeed = 6;                   // of a small one that does not burst

/// Seen from 1 m before nearly nothing, in the dark, shown as it is.
Scene inTheDark(RenderQuality quality) {
    Scene scene = wholeBlock();
    scene.mesh.reset();
    scene.body = std::make_unique<BlockBody>(BlockOptions{.cells = 1, .size = 1e-5f});
    scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
    putIntoFurnace(scene.view, glm::vec3(1e-4f));
    scene.view.quality = quality;
    scene.view.camera.eye = {0, 0.5f, 1};
    scene.view.camera.target = {0, 0.5f, 0};
    scene.view.width = 960;
    scene.view.height = 540;
    return scene;
}

float pixelsPerMetre(const Scene& scene) {
    const float aspect = static_cast<float>(scene.view.width) / static_cast<float>(scene.view.height);
    return 0.5f * static_cast<float>(scene.view.height) / scene.view.camera.halfHeight(aspect);
}

/// Like any but the largest, of which none burst.
GrainDraw sparkAt(glm::vec3 position, glm::vec3 velocity, float age, float heat = 0.45f) {
    return {position,
            kSize,
            {glm::packHalf2x16(glm::vec2(velocity)), glm::packHalf2x16({velocity.z, age})},
            kSeed,
            heat};
}

/// Sums of linear light, and what of it is seen.
struct Streak {
    glm::vec3 light{0};
    int first = 1 << 20, last = -1;  ///< columns
    std::vector<int> thick;          ///< pixels, by column
    std::vector<float> bright;       ///< light, by column
    float length() const { return static_cast<float>(std::max(last - first + 1, 0)); }
    /// Mean of a fifth of it, from `share` on.
    template <class T>
    float mean(const std::vector<T>& of, float share) const {
        const int fifth = (last - first + 1) / 5, from = first + static_cast<int>(share * length());
        float sum = 0;
        for (int x = from; x < from + fifth; ++x) sum += static_cast<float>(of[static_cast<size_t>(x)]);
        return sum / static_cast<float>(fifth);
    }
};
Streak streakIn(const Image& image) {
    constexpr int kSeen = 10;
    Streak streak;
    streak.thick.resize(static_cast<size_t>(image.width));
    streak.bright.resize(static_cast<size_t>(image.width));
    for (int x = 0; x < image.width; ++x)
        for (int y = 0; y < image.height; ++y) {
            const uint8_t* pixel = image.at(x, y);
            const glm::vec3 light(decoded(pixel[0]), decoded(pixel[1]), decoded(pixel[2]));
            streak.light += light;
            streak.bright[static_cast<size_t>(x)] += light.r;
            if (std::max({pixel[0], pixel[1], pixel[2]}) < kSeen) continue;
            streak.thick[static_cast<size_t>(x)] += 1;
            streak.first = std::min(streak.first, x);
            streak.last = std::max(streak.last, x);
        }
    return streak;
}

class Sparks : public GlTest, public testing::WithParamInterface<RenderQuality> {
  protected:
    Scene scene_;

    void SetUp() override {
        GlTest::SetUp();
        scene_ = inTheDark(GetParam());
    }

    Streak drawn(const GrainDraw& spark) {
        writeEffects(*scene_.mesh, {spark}, {});
        return streakIn(drawPicture(renderer(), scene_));
    }
    /// Of a frame between `before` and `after`, whose shutter is open.
    Streak exposed(const std::vector<GrainDraw>& before, const std::vector<GrainDraw>& after,
                   const Lens& lens) {
        MotionBetween motion(shaderFolder());
        writeEffects(*scene_.mesh, before, {});
        if (before.empty()) scene_.mesh->showEffects(false, false);  // as before the first hit
        motion.remember(*scene_.mesh);
        writeEffects(*scene_.mesh, after, {});
        Film film(shaderFolder());
        film.begin(scene_.view.width, scene_.view.height);
        for (uint32_t i = 0; i < lens.samples; ++i) {
            motion.place(*scene_.mesh, pictureMoment(lens, i, lens.samples), kFrame);
            FrameView view = pictureView(scene_.view, lens, i, lens.samples);
            view.opening = pictureOpening(lens, kFrame, i, lens.samples);
            renderer().draw(scene_.mesh.get(), scene_.spheres, view, film.framebuffer());
            film.add();
        }
        return streakIn(developed(film, scene_.view));
    }
};

constexpr glm::vec3 kPlace{0.1f, 0.5f, 0};

TEST_P(Sparks, AStreakIsAsLongAsTheWayWhileTheFilmIsOpen) {
    const float pixels = pixelsPerMetre(scene_);
    for (const float open : {0.005f, 0.01f})
        for (const float speed : {5.0f, 10.0f, 20.0f}) {
            scene_.view.opening.seconds = {-open, 0};
            const float way = speed * open * pixels;
            const Streak streak = drawn(sparkAt(kPlace, {speed, 0, 0}, kLong, 0.7f));
            EXPECT_NEAR(streak.length(), way, 0.1f * way + 4) << speed << " m/s, " << open << " s";
            EXPECT_NEAR(static_cast<float>(streak.last), 480 + kPlace.x * pixels, 4)
                << "its head is where it is";
        }
    scene_.view.opening.seconds = {-0.01f, 0};
    const float way = 10 * 0.003f * pixels;
    EXPECT_NEAR(drawn(sparkAt(kPlace, {10, 0, 0}, 0.003f, 0.7f)).length(), way, 0.1f * way + 4)
        << "it was struck 3 ms ago";
}

TEST_P(Sparks, AStillIsShortBesideABodyOfAMetre) {
    EXPECT_LT(drawn(sparkAt(kPlace, {11, 0, 0}, kLong, 1)).length(), 0.05f * pixelsPerMetre(scene_));
}

TEST_P(Sparks, ItThinsAndDarkensTowardsItsTail) {
    scene_.view.opening.seconds = {-0.01f, 0};
    const Streak streak = drawn(sparkAt(kPlace, {20, 0, 0}, kLong));
    ASSERT_GT(streak.length(), 50);
    EXPECT_GT(streak.mean(streak.bright, 0.75f), 2.2f * streak.mean(streak.bright, 0.1f));
    EXPECT_GT(streak.mean(streak.thick, 0.75f), 1.2f * streak.mean(streak.thick, 0.1f));
}

TEST_P(Sparks, ItGoesFromYellowToRedAsItCools) {
    glm::vec3 last{1e9f};
    for (const float heat : {0.8f, 0.6f, 0.45f, 0.3f}) {
        const glm::vec3 light = drawn(sparkAt(kPlace, {20, 0, 0}, kLong, heat)).light;
        EXPECT_GT(light.r, light.g);
        EXPECT_GT(light.g, light.b);
        EXPECT_LT(light.r, 0.8f * last.r) << heat;
        EXPECT_LT(light.g / light.r, 0.95f * last.g / last.r) << heat;
        last = light;
    }
    EXPECT_LT(last.g, 0.25f * last.r);
}

TEST_P(Sparks, AnOpenShutterShowsTheSameWayOnceHoweverManyPicturesItTakes) {
    const glm::vec3 velocity{12, 0, 0}, before = kPlace - kFrame * velocity;
    for (const float shutter : {0.5f, 1.0f}) {
        scene_.view.opening.seconds = {-shutter * kFrame, 0};
        const Streak still = drawn(sparkAt(kPlace, velocity, kLong));
        for (const uint32_t pictures : {4u, 16u}) {
            const Streak film =
                exposed({sparkAt(before, velocity, kLong - kFrame)}, {sparkAt(kPlace, velocity, kLong)},
                        {.shutter = shutter, .samples = pictures});
            EXPECT_NEAR(film.length(), still.length(), 3) << pictures;
            EXPECT_NEAR(film.light.r / still.light.r, 1, 0.12) << pictures;
            EXPECT_NEAR(static_cast<float>(film.last), static_cast<float>(still.last), 2) << pictures;
        }
    }
}

TEST_P(Sparks, OneThatIsStruckWhileTheShutterIsOpenComesFromThere) {
    const glm::vec3 velocity{12, 0, 0};
    constexpr float kAge = 0.4f * kFrame;
    const Streak film = exposed({}, {sparkAt(kPlace, velocity, kAge)}, {.shutter = 1, .samples = 16});
    const float way = 12 * kAge * pixelsPerMetre(scene_);
    EXPECT_NEAR(film.length(), way, 0.1f * way + 4);
}

/// Sparks at rest, each in the middle of a square: rays of a burst reach far out of it.
TEST_P(Sparks, AFewBurst) {
    constexpr int kColumns = 16, kRows = 9, kSquare = 60;  // px
    std::vector<GrainDraw> sparks;
    for (int k = 0; k < kColumns * kRows; ++k) {
        const glm::vec2 pixel(kSquare * (k % kColumns) - 450, 240 - kSquare * (k / kColumns));
        sparks.push_back(
            sparkAt(glm::vec3(pixel / pixelsPerMetre(scene_), 0) + glm::vec3(0, 0.5f, 0), {}, kLong, 0.7f));
        sparks.back().seed = 7919 * static_cast<uint32_t>(k);
    }
    writeEffects(*scene_.mesh, sparks, {});
    const Image image = drawPicture(renderer(), scene_);
    std::set<int> burst;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::ivec2 off(x % kSquare - kSquare / 2, y % kSquare - kSquare / 2);
            const bool far = off.x * off.x + off.y * off.y > 10 * 10;
            if (far && image.at(x, y)[0] > 20) burst.insert(y / kSquare * kColumns + x / kSquare);
        }
    EXPECT_GE(burst.size(), 1u);
    EXPECT_LE(burst.size(), sparks.size() / 10);
}

TEST_P(Sparks, ItIsNotSeenThroughABodyOrTheFloor) {
    scene_ = wholeBlock();
    scene_.view.quality = GetParam();
    writeEffects(*scene_.mesh, {}, {});
    const Image none = drawPicture(renderer(), scene_);
    for (const glm::vec3 place : {glm::vec3(-0.1f, 0.4f, -0.2f), glm::vec3(0.6f, -0.1f, 0.6f)}) {
        writeEffects(*scene_.mesh, {sparkAt(place, {2, 0, 0}, kLong, 1)}, {});
        EXPECT_LT(differingPixels(drawPicture(renderer(), scene_), none, 6), 4u);
    }
    writeEffects(*scene_.mesh, {sparkAt({0.6f, 0.1f, 0.9f}, {2, 0, 0}, kLong, 1)}, {});
    EXPECT_GT(differingPixels(drawPicture(renderer(), scene_), none, 6), 4u);
}

INSTANTIATE_TEST_SUITE_P(Qualities, Sparks, testing::Values(RenderQuality::kFull, RenderQuality::kDraft),
                         [](const auto& param) {
                             return param.param == RenderQuality::kFull ? "Full" : "Draft";
                         });

}  // namespace
}  // namespace demolish::engine::test
