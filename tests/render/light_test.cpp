// SPDX-License-Identifier: Apache-2.0
// Light obeys geometry: shadow falls where the sun's ray meets the block, and only there; corners are dimmer.
#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "engine/passes/collider_pass.h"
#include "engine/render/frame_uniforms.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

using LightTest = GlTest;

int brightness(const Image& image, int x, int y) {
    const uint8_t* p = image.at(x, y);
    return (p[0] + p[1] + p[2]) / 3;
}

/// Does the sun's ray from a floor point meet the unit block grown (or shrunk) by `margin`?
bool blockHidesSun(const Lighting& light, glm::vec3 p, float margin) {
    const glm::vec3 d = -glm::normalize(light.sun_direction);
    const glm::vec3 low = glm::vec3(-0.5f, 0.0f, -0.5f) - margin, high = glm::vec3(0.5f, 1.0f, 0.5f) + margin;
    const glm::vec3 a = (low - p) / d, b = (high - p) / d;
    const glm::vec3 enter = glm::min(a, b), leave = glm::max(a, b);
    return std::max({enter.x, enter.y, enter.z, 0.0f}) < std::min({leave.x, leave.y, leave.z});
}

/// Pixels on the block's outline belong half to it.
bool onlyFloorAround(const std::vector<uint32_t>& ids, const FrameView& view, int x, int y) {
    for (int k = 0; k < 9; ++k) {
        const int u = std::clamp(x + k % 3 - 1, 0, view.width - 1),
                  v = std::clamp(y + k / 3 - 1, 0, view.height - 1);
        if (ids[static_cast<size_t>(v) * view.width + u] != kFloorId) return false;
    }
    return true;
}

/// A scene whose block stands `away` from the middle; the camera goes with it.
void checkShadowOf(Scene scene, Renderer& renderer, RenderQuality quality, glm::vec3 away) {
    Scene empty = makeScene("empty_floor");
    for (Scene* s : {&scene, &empty}) {
        s->view.quality = quality;
        s->view.camera.eye += away;
        s->view.camera.target += away;
    }
    const Image picture = drawPicture(renderer, scene), reference = drawPicture(renderer, empty);
    const std::vector<uint32_t> ids = renderer.fragmentIds(scene.mesh.get(), {}, scene.view);
    size_t dark = 0, dark_wrong = 0, lit = 0, lit_wrong = 0;
    for (int y = 0; y < scene.view.height; ++y) {
        for (int x = 0; x < scene.view.width; ++x) {
            if (!onlyFloorAround(ids, scene.view, x, y)) continue;
            const Ray ray = pixelRay(scene.view.camera, scene.view.width, scene.view.height,
                                     static_cast<float>(x), static_cast<float>(y));
            const glm::vec3 p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y) - away;
            if (std::max(std::abs(p.x), std::abs(p.z)) > 5.0f) continue;
            const int loss = brightness(reference, x, y) - brightness(picture, x, y);
            if (blockHidesSun(scene.view.lighting, p, -0.08f)) {
                ++dark;
                dark_wrong += loss < 25;
            } else if (!blockHidesSun(scene.view.lighting, p, 0.3f)) {
                ++lit;
                lit_wrong += std::abs(loss) > 4;
            }
        }
    }
    EXPECT_GT(dark, 800u);
    EXPECT_GT(lit, 5000u);
    EXPECT_EQ(dark_wrong, 0u);
    EXPECT_EQ(lit_wrong, 0u);
}

void checkShadow(Renderer& renderer, RenderQuality quality, glm::vec3 away = {0, 0, 0}) {
    Scene scene = wholeBlock();
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; }, [&](uint32_t) { return Motion{.translation = away}; },
        [](uint32_t, uint32_t) { return false; });
    checkShadowOf(std::move(scene), renderer, quality, away);
}

void checkColliderShadow(Renderer& renderer, RenderQuality quality, glm::vec3 away = {0, 0, 0}) {
    Scene scene = solidBlock();
    scene.view.colliders[0].position += away;
    checkShadowOf(std::move(scene), renderer, quality, away);
}

TEST_F(LightTest, ACollidersShadowFallsWhereItHidesTheSun) {
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
        checkColliderShadow(renderer(), quality);
        checkColliderShadow(renderer(), quality, {6, 0, -9});
    }
}

/// The faces towards the sun are evenly bright but for the floor's grain: no stripes of its own shadow.
TEST_F(LightTest, LitFacesOfACollidersBoxShowNoAcne) {
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
        Scene scene = solidBlock();
        scene.view.quality = quality;
        const Image picture = drawPicture(renderer(), scene);
        const std::vector<uint32_t> ids = renderer().fragmentIds(nullptr, {}, scene.view);
        size_t checked = 0, jumps = 0;
        for (int y = 1; y + 1 < scene.view.height; ++y)
            for (int x = 1; x + 1 < scene.view.width; ++x) {
                const auto id = [&](int dx) {
                    return ids[static_cast<size_t>(y) * scene.view.width + x + dx];
                };
                if (id(-1) != kColliderId || id(0) != kColliderId || id(1) != kColliderId) continue;
                ++checked;
                jumps += std::abs(2 * brightness(picture, x, y) - brightness(picture, x - 1, y) -
                                  brightness(picture, x + 1, y)) > 20;
            }
        EXPECT_GT(checked, 5000u);
        EXPECT_LT(jumps, 450u) << "only the edges";
    }
}

/// A plane that leans over the floor shades what lies below it, and no stripe of it falls on itself.
TEST_F(LightTest, APlaneCastsShadowFromItsLitSide) {
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
        Scene scene = makeScene("empty_floor");
        scene.view.quality = quality;
        const Image without = drawPicture(renderer(), scene);
        ColliderDraw plane;
        plane.shape = ColliderShape::kPlane;
        plane.half_size = {0.3f, 0.3f, 0.03f};
        plane.rotation = glm::angleAxis(-1.2f, glm::vec3(1, 0, 0));
        plane.position = {0, 0.6f, 0};
        scene.view.colliders = {plane};
        const Image with = drawPicture(renderer(), scene);
        const std::vector<uint32_t> ids = renderer().fragmentIds(nullptr, {}, scene.view);
        size_t darker = 0, face = 0, jumps = 0;
        for (int y = 1; y + 1 < scene.view.height; ++y)
            for (int x = 1; x + 1 < scene.view.width; ++x) {
                const uint32_t* id = &ids[static_cast<size_t>(y) * scene.view.width + x];
                darker += *id == kFloorId && brightness(without, x, y) - brightness(with, x, y) > 25;
                if (id[-1] != kColliderId || id[0] != kColliderId || id[1] != kColliderId) continue;
                ++face;
                jumps += std::abs(2 * brightness(with, x, y) - brightness(with, x - 1, y) -
                                  brightness(with, x + 1, y)) > 10;
            }
        EXPECT_GT(darker, 400u);
        EXPECT_GT(face, 1000u);
        EXPECT_EQ(jumps, 0u);
    }
}

/// So that the walls of a room cost no time in the shadow map; one that leans does, as above.
TEST_F(LightTest, AnUprightPlaneCastsNone) {
    ColliderDraw wall, box;
    wall.shape = ColliderShape::kPlane;
    ColliderDraw leaning = wall;
    leaning.rotation = glm::angleAxis(-0.1f, glm::vec3(1, 0, 0));
    ColliderPass pass(shaderFolder());
    pass.setColliders(std::vector{wall, box, leaning});
    EXPECT_EQ(pass.count(), 3u);
    EXPECT_EQ(pass.casters(), 2u);
}

/// The block's shadow falls onto a step behind it as well.
TEST_F(LightTest, ACollidersBoxReceivesShadow) {
    Scene scene = wholeBlock();
    ColliderDraw step;
    const glm::vec3 away = glm::normalize(glm::vec3(1, 0, 1) * scene.view.lighting.sun_direction);
    step.position = glm::vec3(0, 0.15f, 0) + 1.2f * away;
    step.half_size = {0.4f, 0.15f, 0.4f};
    scene.view.colliders = {step};
    const Image with = drawPicture(renderer(), scene);
    scene.mesh.reset();
    const Image without = drawPicture(renderer(), scene);
    const std::vector<uint32_t> ids = renderer().fragmentIds(wholeBlock().mesh.get(), {}, scene.view);
    size_t darker = 0;
    for (int y = 0; y < scene.view.height; ++y)
        for (int x = 0; x < scene.view.width; ++x)
            if (ids[static_cast<size_t>(y) * scene.view.width + x] == kColliderId)
                darker += brightness(without, x, y) - brightness(with, x, y) > 25;
    EXPECT_GT(darker, 200u);
}

TEST_F(LightTest, ShadowFallsWhereTheSunIsHidden) {
    checkShadow(renderer(), RenderQuality::kFull);
}
TEST_F(LightTest, DraftShadowFallsThereToo) {
    checkShadow(renderer(), RenderQuality::kDraft);
}

TEST_F(LightTest, ShadowFallsFarFromTheSceneToo) {
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft})
        checkShadow(renderer(), quality, {6, 0, -9});
}

TEST(ShadowRegions, MoveByWholeTexelsWithTheCamera) {
    constexpr int kTexels = 1024;
    FrameView view = makeScene("empty_floor").view;
    const glm::vec4 point(2.3f, 0.1f, -4.7f, 1);
    const FrameUniforms first = makeFrameUniforms(view, kTexels);
    for (int k = 1; k <= 20; ++k) {
        const glm::vec3 step = 0.137f * static_cast<float>(k) * glm::vec3(1, 0.2f, -0.6f);
        view.camera.eye = glm::vec3(1.75f, 1.2f, 2.35f) + step;
        view.camera.target = glm::vec3(0, 0.42f, 0) + step;
        const FrameUniforms moved = makeFrameUniforms(view, kTexels);
        EXPECT_EQ(moved.light_matrix[0], first.light_matrix[0]) << "the near region stays with the scene";
        EXPECT_EQ(moved.shadow[1], first.shadow[1]);
        const glm::vec4 shift = (moved.light_matrix[1] - first.light_matrix[1]) * point * float(kTexels);
        EXPECT_NEAR(shift.x, std::round(shift.x), 0.01f);
        EXPECT_NEAR(shift.y, std::round(shift.y), 0.01f);
    }
}

TEST(ShadowRegions, FarOneHoldsWhatTheCameraLooksAt) {
    FrameView view = makeScene("empty_floor").view;
    for (const float away : {0.0f, 10.0f, 300.0f}) {
        view.camera.target = {away, 0, -away};
        const FrameUniforms frame = makeFrameUniforms(view, 1024);
        const glm::vec4 p = frame.light_matrix[1] * glm::vec4(view.camera.target, 1);
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(p[axis], 0.5f, 0.01f);
        // Round the target it reaches at least as far as the camera stands off.
        EXPECT_GE(0.5f * frame.shadow[1].z, glm::length(view.camera.target - view.camera.eye));
        EXPECT_GE(frame.shadow[1].z, 4 * frame.shadow[0].z);
    }
}

TEST_F(LightTest, NothingCastsNoShadow) {
    // Soft and hard shadows agree on an empty floor, also where it leaves the shadow map through a side or
    // its far end.
    Scene scene = makeScene("empty_floor");
    const Image soft = drawPicture(renderer(), scene);
    scene.view.quality = RenderQuality::kDraft;
    const Image hard = drawPicture(renderer(), scene);
    int largest = 0;
    for (size_t i = 0; i < soft.pixels.size(); ++i)
        largest = std::max(largest, std::abs(soft.pixels[i] - hard.pixels[i]));
    EXPECT_LE(largest, 2);
}

TEST_F(LightTest, LitFacesShowNoAcne) {
    Scene scene = wholeBlock();
    scene.view.look.exterior_roughness = 1.0f;
    const Image picture = drawPicture(renderer(), scene);
    const std::vector<uint32_t> ids = renderer().fragmentIds(scene.mesh.get(), {}, scene.view);
    size_t checked = 0, jumps = 0;
    for (int y = 1; y + 1 < scene.view.height; ++y) {
        for (int x = 1; x + 1 < scene.view.width; ++x) {
            const auto id = [&](int dx, int dy) {
                return ids[static_cast<size_t>(y + dy) * scene.view.width + x + dx];
            };
            if (id(0, 0) != 0 || id(1, 0) != 0 || id(-1, 0) != 0 || id(0, 1) != 0 || id(0, -1) != 0) continue;
            ++checked;
            const int bend =
                2 * brightness(picture, x, y) - brightness(picture, x - 1, y) - brightness(picture, x + 1, y);
            jumps += std::abs(bend) > 30;
        }
    }
    EXPECT_GT(checked, 5000u);
    // The block's three edges are the only jumps there are: a column of pixels each, of at most two pixels
    // width.
    EXPECT_LT(jumps, 450u);
}

TEST_F(LightTest, FloorIsDimmerBesideTheBlock) {
    Scene scene = wholeBlock();
    const Image full = drawPicture(renderer(), scene);
    scene.view.quality = RenderQuality::kDraft;
    const Image draft = drawPicture(renderer(), scene);
    // On the sunny side, 3 cm before the block's base and half a metre before it.
    const auto loss = [&](glm::vec3 p) {
        const float aspect = static_cast<float>(scene.view.width) / static_cast<float>(scene.view.height);
        const glm::vec4 clip =
            scene.view.camera.projection(aspect) * scene.view.camera.view() * glm::vec4(p, 1);
        const int x =
            static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(scene.view.width));
        const int y =
            static_cast<int>((0.5f - clip.y / clip.w * 0.5f) * static_cast<float>(scene.view.height));
        return brightness(draft, x, y) - brightness(full, x, y);
    };
    EXPECT_GT(loss({-0.2f, 0.0f, 0.53f}), loss({-0.2f, 0.0f, 1.0f}) + 5);
}

/// Writes the block's place as a foreign API does: the mesh does not notice.
void placeUnnoticed(const FractureMesh& mesh, float x) {
    const float transform[8] = {0, 0, 0, 1, x, 0, 0, 0};
    glNamedBufferSubData(mesh.stream(StreamId::kTransforms).id(), 0, sizeof(transform), transform);
}

TEST_F(LightTest, TheShadowMapIsDrawnAgainOnlyWhenWhatItShowsHasChanged) {
    for (const RenderQuality quality : {RenderQuality::kDraft, RenderQuality::kFull}) {
        Scene scene = wholeBlock();
        scene.view.width = 240;
        scene.view.height = 135;
        scene.view.quality = quality;
        const Image before = drawPicture(renderer(), scene);
        EXPECT_TRUE(before.pixels == drawPicture(renderer(), scene).pixels);
        placeUnnoticed(*scene.mesh, 0.4f);
        const Image old_shadow = drawPicture(renderer(), scene);
        scene.mesh->touch();
        const Image after = drawPicture(renderer(), scene);
        EXPECT_GT(differingPixels(before, after, 20), 500u);
        EXPECT_GT(differingPixels(old_shadow, after, 20), 100u);
        Scene anew = wholeBlock();
        placeUnnoticed(*anew.mesh, 0.4f);
        anew.view = scene.view;
        EXPECT_TRUE(after.pixels == drawPicture(renderer(), anew).pixels);
    }
}

TEST_F(LightTest, ShadowsFollowBallsAndTheSun) {
    Scene scene = makeScene("empty_floor");
    scene.view.width = 240;
    scene.view.height = 135;
    const auto drawn = [&] { return drawPicture(renderer(), scene); };
    const Image empty = drawn();
    scene.spheres = {{{0, 0.5f, 0}, 0.3f}};
    const Image ball = drawn();
    EXPECT_GT(differingPixels(empty, ball, 20), 500u);
    scene.spheres[0].position[1] = 0.3f;
    const Image lower = drawn();
    scene.view.lighting.sun_direction.x *= -1;
    const Image other_sun = drawn();
    EXPECT_GT(differingPixels(lower, other_sun, 20), 100u);
    scene.view.lighting.sun_direction.x *= -1;
    EXPECT_TRUE(lower.pixels == drawn().pixels);
    scene.spheres.clear();
    EXPECT_TRUE(empty.pixels == drawn().pixels);
}

}  // namespace
}  // namespace demolish::engine::test
