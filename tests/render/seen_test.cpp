// SPDX-License-Identifier: Apache-2.0
// Software renderers leave out what nothing is seen of: not a bit of the picture changes, and much is left
// out.
#include <glm/gtc/constants.hpp>

#include <span>
#include <vector>

#include "engine/render/seen_cracks.h"
#include "engine/render/seen_triangles.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class Seen : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (!context().info().software) GTEST_SKIP() << "GPUs draw or compute everything";
    }

    static void expectSamePicture(Scene& scene) {
        scene.view.rasteriser = Rasteriser::kDraw;
        const Image all = drawPicture(renderer(), scene);
        scene.view.rasteriser = Rasteriser::kAuto;
        const Image seen = drawPicture(renderer(), scene);
        EXPECT_EQ(differingPixels(all, seen, 0), 0u);
    }
};

Scene small(const std::string& name, int samples) {
    Scene scene = makeScene(name);
    scene.view.width = 320;
    scene.view.height = 180;
    scene.view.samples = samples;
    return scene;
}

/// `times` as far from what it looks at, to the other side where it is negative.
void moveCamera(Camera& camera, float times) {
    camera.eye = camera.target + times * (camera.eye - camera.target);
    camera.eye.y = std::abs(camera.eye.y);
}

TEST_F(Seen, ThePictureIsTheSameNearAndFar) {
    for (const char* name : {"broken_ball", "cracked_block"})
        for (const int samples : {1, 2, 4})
            for (const float times : {0.15f, 1.0f, -1.0f, 6.0f}) {
                SCOPED_TRACE(testing::Message() << name << ' ' << samples << ' ' << times);
                Scene scene = small(name, samples);
                moveCamera(scene.view.camera, times);
                expectSamePicture(scene);
            }
}

TEST_F(Seen, ADraftOfBodiesThatDifferInColourIsTheSame) {
    Scene scene = small("broken_ball", 2);
    scene.view.quality = RenderQuality::kDraft;
    scene.view.look.variation = 0.1f;
    expectSamePicture(scene);
}

/// Small triangles are then rasterised on the CPU: where one meets the next, a sample may show the other one.
TEST_F(Seen, ADraftDiffersByRounding) {
    for (const char* name : {"broken_ball", "cracked_block"})
        for (const int samples : {1, 2, 4})
            for (const float times : {0.15f, 1.0f, -1.0f, 6.0f}) {
                SCOPED_TRACE(testing::Message() << name << ' ' << samples << ' ' << times);
                Scene scene = small(name, samples);
                scene.view.quality = RenderQuality::kDraft;
                moveCamera(scene.view.camera, times);
                scene.view.rasteriser = Rasteriser::kDraw;
                const Image all = drawPicture(renderer(), scene);
                scene.view.rasteriser = Rasteriser::kAuto;
                const Image seen = drawPicture(renderer(), scene);
                const size_t pixels = all.pixels.size() / 4;
                EXPECT_LE(differingPixels(all, seen, 0), pixels / 200);
                EXPECT_LE(differingPixels(all, seen, 2), pixels / 5000);
                EXPECT_LE(differingPixels(all, seen, 16), 2u);
            }
}

TEST_F(Seen, WhatMovesIsFoundAnew) {
    Scene scene = small("broken_ball", 1);
    const Image before = drawPicture(renderer(), scene);
    scene.body->write(
        *scene.mesh, [](uint32_t cell) { return cell; },
        [](uint32_t) {
            return Motion{{1, 0, 0, 0}, {0.3f, 0.2f, 0}};
        },
        [](uint32_t, uint32_t) { return false; });
    const Image after = drawPicture(renderer(), scene);
    EXPECT_GT(differingPixels(before, after, 8), 1000u);
    expectSamePicture(scene);
}

/// Seen along z, from where it is 1.
uint32_t seenOf(const FractureMesh& mesh, float scale, bool hidden = true, int size = 64) {
    glm::mat4 to_clip{glm::mat3(scale)};
    to_clip[3].z = 0.5f;
    const SampleGrid grid(to_clip, size, size);
    SeenTriangles seen;
    seen.find(mesh, nullptr, {&grid, 1}, {.hidden = hidden});
    return seen.in(0).exterior.count + seen.in(0).interior.count;
}

TEST_F(Seen, BacksAndWhatIsTooSmallAreLeftOut) {
    const Scene scene = makeScene("broken_ball");
    const uint32_t near = seenOf(*scene.mesh, 0.5f), far = seenOf(*scene.mesh, 1e-3f);
    EXPECT_GT(near, 0u);
    EXPECT_LT(far, near / 20);
}

TEST_F(Seen, WhatLiesBehindOthersIsLeftOut) {
    const Scene scene = makeScene("broken_ball");
    const uint32_t all = seenOf(*scene.mesh, 0.5f, true, 256), shown = seenOf(*scene.mesh, 0.5f, false, 256);
    EXPECT_GT(shown, 0u);
    EXPECT_LT(shown, 0.8 * all);
}

TEST_F(Seen, ADraftIsTheSameEveryTime) {
    Scene scene = small("broken_ball", 2);
    scene.view.quality = RenderQuality::kDraft;
    const Image first = drawPicture(renderer(), scene);
    const Camera camera = scene.view.camera;
    moveCamera(scene.view.camera, 0.5f);
    drawPicture(renderer(), scene);  // leaves nothing behind
    scene.view.camera = camera;
    EXPECT_EQ(differingPixels(first, drawPicture(renderer(), scene), 0), 0u);
}

/// Lines between the halves of a block, of which the second is moved by `gap`. `frame`: as SeenCracks has it.
uint32_t linesAcross(float gap, float width, const FrameUniforms* frame = nullptr) {
    const BlockBody body({.cells = 2});
    FractureMesh mesh = body.makeMesh();
    const auto half = [&](uint32_t cell) { return body.cellCentre(cell).x > 0 ? 1u : 0u; };
    const auto all = [](uint32_t) { return 0u; };
    body.write(
        mesh, all, [](uint32_t) { return Motion{}; },
        [&](uint32_t a, uint32_t b) { return half(a) != half(b); });
    std::vector<uint32_t> slots(body.cellCount());
    for (uint32_t cell = 0; cell < body.cellCount(); ++cell) slots[cell] = half(cell);
    mesh.stream(StreamId::kParticleFragment).upload(std::as_bytes(std::span(slots)));
    const float moved[16] = {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, gap, 0, 0, 0};
    mesh.stream(StreamId::kTransforms).upload(std::as_bytes(std::span(moved)));
    SeenCracks seen;
    seen.find(mesh, width, frame);
    return seen.indexCount() / 6;
}

TEST_F(Seen, LinesOfPiecesThatPartedAreLeftOut) {
    EXPECT_GT(linesAcross(0, 0.01f), 0u);
    EXPECT_EQ(linesAcross(0.029f, 0.01f), linesAcross(0, 0.01f));
    EXPECT_EQ(linesAcross(0.04f, 0.01f), 0u);
}

TEST_F(Seen, LinesTurnedAwayOrTooThinAreLeftOut) {
    FrameView view = wholeBlock().view;
    const FrameUniforms near = makeFrameUniforms(view, 64);
    moveCamera(view.camera, 1e5f);
    const FrameUniforms far = makeFrameUniforms(view, 64);
    const uint32_t all = linesAcross(0, 0.01f), shown = linesAcross(0, 0.01f, &near);
    EXPECT_GT(shown, 0u);
    EXPECT_LT(shown, 0.8 * all);
    EXPECT_EQ(linesAcross(0, 0.01f, &far), 0u);
}

}  // namespace
}  // namespace demolish::engine::test
