// SPDX-License-Identifier: Apache-2.0
// A click finds what is drawn there: fragment, place, floor, ball or nothing.
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

using PickTest = GlTest;

/// Pixel that shows a world point.
glm::ivec2 pixelOf(const FrameView& view, glm::vec3 p) {
    const float aspect = static_cast<float>(view.width) / static_cast<float>(view.height);
    const glm::vec4 clip = view.camera.projection(aspect) * view.camera.view() * glm::vec4(p, 1);
    const glm::vec2 ndc = glm::vec2(clip) / clip.w;
    return {static_cast<int>((ndc.x * 0.5f + 0.5f) * static_cast<float>(view.width)),
            static_cast<int>((0.5f - ndc.y * 0.5f) * static_cast<float>(view.height))};
}

TEST_F(PickTest, FindsTheSurfaceUnderThePixel) {
    const Scene scene = wholeBlock();
    const glm::vec3 place(0.5f, 0.62f, 0.11f);
    const glm::ivec2 pixel = pixelOf(scene.view, place);
    const Pick pick = renderer().pick(scene.mesh.get(), {}, scene.view, pixel.x, pixel.y);
    ASSERT_TRUE(pick.hit);
    EXPECT_EQ(pick.fragment, 0u);
    EXPECT_NEAR(pick.position[0], place.x, 1e-3f);
    for (int i = 1; i < 3; ++i) EXPECT_NEAR(pick.position[i], place[i], 0.02f) << i;  // a pixel is 8 mm wide
}

TEST_F(PickTest, FindsFloorSphereAndNothing) {
    Scene scene = wholeBlock();
    scene.spheres = {{{1.0f, 0.5f, 0.6f}, 0.2f}};
    const glm::ivec2 floor = pixelOf(scene.view, {-0.9f, 0.0f, 0.9f});
    const Pick on_floor = renderer().pick(scene.mesh.get(), scene.spheres, scene.view, floor.x, floor.y);
    EXPECT_EQ(on_floor.fragment, kFloorId);
    EXPECT_NEAR(on_floor.position[1], 0.0f, 1e-3f);

    const glm::vec3 centre(1.0f, 0.5f, 0.6f);
    const glm::ivec2 ball = pixelOf(scene.view, centre);
    const Pick on_ball = renderer().pick(scene.mesh.get(), scene.spheres, scene.view, ball.x, ball.y);
    EXPECT_EQ(on_ball.fragment, kSphereId);
    EXPECT_NEAR(
        glm::distance(centre, glm::vec3(on_ball.position[0], on_ball.position[1], on_ball.position[2])), 0.2f,
        2e-3f);

    EXPECT_FALSE(renderer().pick(scene.mesh.get(), scene.spheres, scene.view, 5, 2).hit);
    EXPECT_FALSE(renderer().pick(scene.mesh.get(), scene.spheres, scene.view, -1, 4000).hit);
}

TEST_F(PickTest, AgreesWithTheIdPicture) {
    const Scene scene = brokenBlock();
    const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
    for (int y = 20; y < scene.view.height; y += 40) {
        for (int x = 13; x < scene.view.width; x += 37) {
            const Pick pick = renderer().pick(scene.mesh.get(), {}, scene.view, x, y);
            ASSERT_EQ(pick.fragment, ids[static_cast<size_t>(y) * scene.view.width + x]) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace demolish::engine::test
