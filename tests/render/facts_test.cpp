// SPDX-License-Identifier: Apache-2.0
// What must be true of the pictures on every driver: who covers which pixel, no holes, no seams.
#include <algorithm>
#include <cstdlib>
#include <map>

#include "engine/image/compare.h"
#include "engine/render/colour_ramp.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class Facts : public GlTest {
  protected:
    static std::vector<uint32_t> idsOf(const Scene& scene) {
        return renderer().fragmentIds(scene.mesh.get(), scene.spheres, scene.view);
    }
};

std::map<uint32_t, size_t> histogram(const std::vector<uint32_t>& ids) {
    std::map<uint32_t, size_t> counts;
    for (const uint32_t id : ids) ++counts[id];
    return counts;
}

/// Does the ray through a pixel meet the unit block that stands on the floor?
bool hitsBlock(const FrameView& view, float x, float y) {
    const Ray ray = pixelRay(view.camera, view.width, view.height, x, y);
    const glm::vec3 low(-0.5f, 0.0f, -0.5f), high(0.5f, 1.0f, 0.5f);
    const glm::vec3 a = (low - ray.origin) / ray.direction, b = (high - ray.origin) / ray.direction;
    const glm::vec3 enter = glm::min(a, b), leave = glm::max(a, b);
    return std::max({enter.x, enter.y, enter.z}) < std::min({leave.x, leave.y, leave.z});
}

/// Pixels whose whole neighbourhood hits (misses) the block must (must not) show it. Returns how many do not
/// obey.
template <class IsBlock>
size_t silhouetteErrors(const Scene& scene, const std::vector<uint32_t>& ids, const IsBlock& is_block) {
    size_t errors = 0, certain = 0;
    for (int y = 1; y + 1 < scene.view.height; ++y) {
        for (int x = 1; x + 1 < scene.view.width; ++x) {
            int hits = 0;
            for (int k = 0; k < 9; ++k) {
                hits += hitsBlock(scene.view, static_cast<float>(x + k % 3 - 1),
                                  static_cast<float>(y + k / 3 - 1));
            }
            if (hits != 0 && hits != 9) continue;
            ++certain;
            errors += is_block(ids[static_cast<size_t>(y) * scene.view.width + x]) != (hits == 9);
        }
    }
    EXPECT_GT(certain, ids.size() * 9 / 10);
    return errors;
}

Scene shatteredInPlace() {
    Scene scene = wholeBlock();
    scene.body->write(
        *scene.mesh, [](uint32_t cell) { return cell; }, [](uint32_t) { return Motion{}; },
        [](uint32_t, uint32_t) { return false; });
    return scene;
}

TEST_F(Facts, WholeBlockFillsItsSilhouetteAndNothingElse) {
    const Scene scene = wholeBlock();
    const std::vector<uint32_t> ids = idsOf(scene);
    EXPECT_EQ(silhouetteErrors(scene, ids, isBody), 0u);
    const auto counts = histogram(ids);
    EXPECT_EQ(counts.size(), 3u);
    EXPECT_TRUE(counts.contains(0) && counts.contains(kFloorId) && counts.contains(kBackgroundId));
}

TEST_F(Facts, ACollidersBoxFillsItsSilhouetteAndNothingElse) {
    const Scene scene = solidBlock();
    const std::vector<uint32_t> ids = idsOf(scene);
    const auto isCollider = [](uint32_t id) { return id == kColliderId; };
    EXPECT_EQ(silhouetteErrors(scene, ids, isCollider), 0u);
    EXPECT_EQ(histogram(ids).size(), 3u);
}

/// Its lit picture agrees: each of the three faces has a light of its own, and round it lies floor.
TEST_F(Facts, TheFacesOfACollidersBoxAreSeen) {
    Scene scene = solidBlock();
    const Image with = drawPicture(renderer(), scene);
    const std::vector<uint32_t> ids = idsOf(scene);
    scene.view.colliders.clear();
    const Image without = drawPicture(renderer(), scene);
    const auto brightnessAt = [&](glm::vec3 p) {
        const FrameView& view = scene.view;
        const float aspect = static_cast<float>(view.width) / static_cast<float>(view.height);
        const glm::vec4 clip = view.camera.projection(aspect) * view.camera.view() * glm::vec4(p, 1);
        const auto x = static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * static_cast<float>(view.width));
        const auto y = static_cast<int>((0.5f - clip.y / clip.w * 0.5f) * static_cast<float>(view.height));
        EXPECT_EQ(ids[static_cast<size_t>(y) * view.width + x], kColliderId);
        const uint8_t* c = with.at(x, y);
        return c[0] + c[1] + c[2];
    };
    const int top = brightnessAt({0, 1, 0}), front = brightnessAt({0, 0.5f, 0.5f}),
              side = brightnessAt({0.5f, 0.5f, 0});
    EXPECT_GT(std::abs(top - front), 20);
    EXPECT_GT(std::abs(top - side), 20);
    EXPECT_GT(std::abs(front - side), 20);
    EXPECT_GT(differingPixels(with, without, 20), 5000u);
}

TEST_F(Facts, WhatStandsBeforeAColliderHidesItAndWhatLiesBehindItIsHidden) {
    Scene scene = solidBlock();
    scene.spheres = {{{0.9f, 0.5f, 1.2f}, 0.1f}, {{-0.4f, 0.3f, -0.8f}, 0.1f}};
    const auto counts = histogram(idsOf(scene));
    ASSERT_TRUE(counts.contains(kSphereId));
    const size_t seen = counts.at(kSphereId);
    scene.spheres.pop_back();
    EXPECT_EQ(histogram(idsOf(scene)).at(kSphereId), seen);
    const Image near = drawPicture(renderer(), scene);
    scene.spheres.push_back({{-0.1f, 0.3f, -0.1f}, 0.1f});  // inside the block
    EXPECT_EQ(differingPixels(near, drawPicture(renderer(), scene), 0), 0u);
}

/// A wall behind the block, tilted and turned; its drawn face ends at 1.2 m to each side.
ColliderDraw tiltedPlane() {
    ColliderDraw plane;
    plane.shape = ColliderShape::kPlane;
    plane.rotation = glm::angleAxis(0.5f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.6f, glm::vec3(1, 0, 0));
    plane.half_size = {1.2f, 1.2f, 0.05f};
    plane.position = glm::vec3(-0.3f, 0.4f, -0.6f) - plane.rotation * glm::vec3(0, 0, 0.05f);
    return plane;
}

/// Does the ray through a pixel come from the free side to the drawn face, above the floor?
bool hitsPlane(const FrameView& view, const ColliderDraw& plane, float x, float y) {
    const Ray ray = pixelRay(view.camera, view.width, view.height, x, y);
    const glm::quat to_own = glm::conjugate(plane.rotation);
    const glm::vec3 from = to_own * (ray.origin - plane.position), way = to_own * ray.direction;
    const float along = (plane.half_size.z - from.z) / way.z;
    const glm::vec3 at = from + along * way;
    return way.z < 0 && along > 0 && std::abs(at.x) < plane.half_size.x &&
           std::abs(at.y) < plane.half_size.y && ray.origin.y + along * ray.direction.y > 0;
}

TEST_F(Facts, APlaneIsSeenWhereItIs) {
    Scene scene = makeScene("empty_floor");
    const Image without = drawPicture(renderer(), scene);
    scene.view.colliders = {tiltedPlane()};
    const Image with = drawPicture(renderer(), scene);
    const std::vector<uint32_t> ids = idsOf(scene);
    size_t seen = 0, errors = 0, alike = 0;
    for (int y = 1; y + 1 < scene.view.height; ++y)
        for (int x = 1; x + 1 < scene.view.width; ++x) {
            int hits = 0;
            for (int k = 0; k < 9; ++k)
                hits += hitsPlane(scene.view, scene.view.colliders[0], static_cast<float>(x + k % 3 - 1),
                                  static_cast<float>(y + k / 3 - 1));
            if (hits != 0 && hits != 9) continue;
            const bool is_plane = ids[static_cast<size_t>(y) * scene.view.width + x] == kColliderId;
            errors += is_plane != (hits == 9);
            seen += is_plane;
            alike += is_plane && std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y));
        }
    EXPECT_EQ(errors, 0u);
    EXPECT_GT(seen, 5000u);
    EXPECT_LT(alike, seen / 100) << "its pixels show it";
}

/// Walls stand round a scene: one between the eye and the bodies must hide nothing, nor one before the sun.
TEST_F(Facts, FromBehindAPlaneIsNotThere) {
    Scene scene = wholeBlock();
    const Image without = drawPicture(renderer(), scene);
    ColliderDraw wall;
    wall.shape = ColliderShape::kPlane;
    wall.half_size = {3, 3, 0.05f};
    const glm::vec3 to_eye = scene.view.camera.eye - scene.view.camera.target;
    wall.rotation = glm::quatLookAt(glm::normalize(to_eye), glm::vec3(0, 1, 0));  // looks at the block
    wall.position = scene.view.camera.target + 0.6f * to_eye;
    ASSERT_GT(glm::dot(scene.view.lighting.sun_direction, wall.rotation * glm::vec3(0, 0, 1)), 0)
        << "the sun is behind it as well";
    scene.view.colliders = {wall};
    EXPECT_FALSE(histogram(idsOf(scene)).contains(kColliderId));
    EXPECT_EQ(differingPixels(without, drawPicture(renderer(), scene), 2), 0u);
}

TEST_F(Facts, FragmentsThatHaveNotMovedLeaveNoHole) {
    const Scene scene = shatteredInPlace();
    EXPECT_EQ(silhouetteErrors(scene, idsOf(scene), isBody), 0u);
}

TEST_F(Facts, FragmentsThatHaveNotMovedShowNoSeam) {
    const Image whole = drawPicture(renderer(), wholeBlock());
    const Image shattered = drawPicture(renderer(), shatteredInPlace());
    // The broken faces lie exactly behind the outside; only samples right on an edge may see one.
    EXPECT_LT(differingPixels(whole, shattered, 8), whole.pixels.size() / 4 / 500);
}

TEST_F(Facts, EveryFragmentOfTheBrokenBlockIsSeen) {
    const Scene scene = brokenBlock();
    const auto counts = histogram(idsOf(scene));
    for (uint32_t slot = 0; slot < 7;
         ++slot) {  // cell 7 hides nothing: all but the far lower corner face the camera
        ASSERT_TRUE(counts.contains(slot)) << "fragment " << slot;
    }
    size_t body = 0;
    for (const auto& [id, count] : counts) body += isBody(id) ? count : 0;
    const double share =
        static_cast<double>(body) / (static_cast<double>(scene.view.width) * scene.view.height);
    EXPECT_GT(share, 0.10);
    EXPECT_LT(share, 0.35);
}

TEST_F(Facts, ParticleViewShowsTheSameFragments) {
    Scene scene = brokenBlock();
    scene.view.mode = ViewMode::kParticles;
    const auto counts = histogram(idsOf(scene));
    for (uint32_t slot = 0; slot < 7; ++slot) EXPECT_TRUE(counts.contains(slot)) << "fragment " << slot;
}

TEST_F(Facts, HorizonIsWhereTheCameraLooksLevel) {
    const Scene scene = makeScene("empty_floor");
    const std::vector<uint32_t> ids = idsOf(scene);
    const FrameView& view = scene.view;
    for (const int x : {0, view.width / 2, view.width - 1}) {
        int level = 0, seen = 0;
        while (
            pixelRay(view.camera, view.width, view.height, static_cast<float>(x), static_cast<float>(level))
                .direction.y > 0)
            ++level;
        while (ids[static_cast<size_t>(seen) * view.width + x] == kBackgroundId) ++seen;
        EXPECT_NEAR(seen, level, 2) << "column " << x;
        for (int y = seen; y < view.height; ++y)
            ASSERT_EQ(ids[static_cast<size_t>(y) * view.width + x], kFloorId);
    }
}

TEST_F(Facts, BackgroundIsTheSky) {
    const Scene scene = wholeBlock(), empty = makeScene("empty_floor");
    const Image picture = drawPicture(renderer(), scene), sky = drawPicture(renderer(), empty);
    const std::vector<uint32_t> ids = idsOf(scene);
    for (int x = 0; x < scene.view.width; ++x) {
        ASSERT_EQ(ids[x], kBackgroundId);
        for (int c = 0; c < 3; ++c) ASSERT_EQ(picture.at(x, 0)[c], sky.at(x, 0)[c]);
        EXPECT_GT(picture.at(x, 0)[2], picture.at(x, 0)[0]) << "the sky is blue";
    }
}

TEST_F(Facts, TheSameFrameIsTheSamePicture) {
    const Scene scene = brokenBlock();
    EXPECT_EQ(drawPicture(renderer(), scene).pixels, drawPicture(renderer(), scene).pixels);
}

TEST_F(Facts, NothingIsLeftOfThePictureBefore) {
    const Scene whole = wholeBlock(), broken = brokenBlock();
    Scene draft = wholeBlock();
    draft.view.quality = RenderQuality::kDraft;
    Renderer fresh(shaderFolder());
    const Image expected = drawPicture(fresh, whole);
    EXPECT_NE(drawPicture(renderer(), broken).pixels, expected.pixels);
    EXPECT_EQ(drawPicture(renderer(), whole).pixels, expected.pixels);
    drawPicture(renderer(), broken);
    drawPicture(renderer(), draft);
    EXPECT_EQ(drawPicture(renderer(), whole).pixels, expected.pixels);
}

TEST_F(Facts, TheColourScaleGetsLighterFromEndToEnd) {
    const ColourRamp ramp(shaderFolder());
    const GLsizei width = ramp.texture().width();
    std::vector<uint8_t> texels(4 * static_cast<size_t>(width));
    glGetTextureImage(ramp.texture().id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(texels.size()),
                      texels.data());
    const auto luminance = [&](int x) {
        const uint8_t* t = &texels[4 * static_cast<size_t>(x)];
        return 0.2126 * t[0] + 0.7152 * t[1] + 0.0722 * t[2];
    };
    for (int x = 16; x < width; x += 16) EXPECT_GT(luminance(x), luminance(x - 16)) << x;
    EXPECT_GT(texels[2], texels[0]) << "blue";
    EXPECT_GT(texels[texels.size() - 4], texels[texels.size() - 2]) << "yellow";
}

TEST_F(Facts, MeshThatWasNeverWrittenStandsWhole) {
    const BlockBody body({.cells = 2});
    const FractureMesh mesh = body.makeMesh();
    FrameView view = wholeBlock().view;
    const auto counts = histogram(renderer().fragmentIds(&mesh, {}, view));
    EXPECT_TRUE(counts.contains(0));
    EXPECT_EQ(counts.size(), 3u);
}

}  // namespace
}  // namespace demolish::engine::test
