// SPDX-License-Identifier: Apache-2.0
// Spheres and capsules are seen where a ray meets them, and shade what lies behind them.
#include <algorithm>
#include <cmath>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class RoundColliders : public GlTest {
  protected:
    static std::vector<uint32_t> idsOf(const Scene& scene) {
        return renderer().fragmentIds(scene.mesh.get(), scene.spheres, scene.view);
    }
};

ColliderDraw ball() {
    ColliderDraw ball;
    ball.shape = ColliderShape::kSphere;
    ball.position = {0.1f, 0.6f, -0.1f};
    ball.half_size = glm::vec3(0.5f);
    return ball;
}
/// 0.25 m thick, its line 1 m long; hangs over the floor.
ColliderDraw rod() {
    ColliderDraw rod;
    rod.shape = ColliderShape::kCapsule;
    rod.position = {0, 0.55f, 0};
    rod.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(0.3f, 1, 0.2f)));
    rod.half_size = {0.25f, 0.25f, 0.75f};
    return rod;
}

/// m, from a ray's line to that of the rod, or to the middle of the ball.
float lineToLine(const ColliderDraw& solid, const Ray& ray) {
    const glm::quat to_own = glm::conjugate(solid.rotation);
    const glm::vec3 from = to_own * (ray.origin - solid.position),
                    way = glm::normalize(to_own * ray.direction);
    const float half = solid.half_size.z - solid.half_size.x;
    float nearest = 1e30f;
    constexpr int kSteps = 2000;
    for (int k = 0; k <= kSteps; ++k) {
        const glm::vec3 away = glm::vec3(0, 0, half * (2.0f * static_cast<float>(k) / kSteps - 1)) - from;
        nearest = std::min(nearest, glm::length(away - std::max(glm::dot(away, way), 0.0f) * way));
        if (half <= 0) break;
    }
    return nearest;
}

Scene sceneOf(const ColliderDraw& solid) {
    Scene scene = makeScene("empty_floor");
    scene.view.width = 320;
    scene.view.height = 180;
    scene.view.colliders = {solid};
    return scene;
}

/// Means of the brightness of a face at y = `height`, near its sides and away from them; it is a square of
/// half side `half` about the y axis.
struct FaceLight {
    double rim = 0, inside = 0;
};
FaceLight faceLight(const Scene& scene, const Image& picture, float height, float half) {
    double rim = 0, inside = 0;
    size_t rims = 0, insides = 0;
    for (int y = 0; y < scene.view.height; ++y)
        for (int x = 0; x < scene.view.width; ++x) {
            const Ray ray = pixelRay(scene.view.camera, scene.view.width, scene.view.height,
                                     static_cast<float>(x), static_cast<float>(y));
            const glm::vec3 at = ray.origin + (height - ray.origin.y) / ray.direction.y * ray.direction;
            const float from_side = half - std::max(std::abs(at.x), std::abs(at.z));
            if (from_side < 0.004f) continue;
            const uint8_t* p = picture.at(x, y);
            const double light = (p[0] + p[1] + p[2]) / 3.0;
            if (from_side < 0.012f) rim += light, ++rims;
            if (from_side > 0.1f) inside += light, ++insides;
        }
    return {rim / static_cast<double>(rims), inside / static_cast<double>(insides)};
}

/// Where a box ends its stone is worn, so that it is no knife. The same places of a larger one lie within.
TEST_F(RoundColliders, EdgesOfABoxAreWorn) {
    ColliderDraw box;
    box.half_size = {0.5f, 0.2f, 0.5f};
    box.position = {0, 0.2f, 0};
    const Scene small = sceneOf(box);
    box.half_size = {0.6f, 0.2f, 0.6f};
    const Scene large = sceneOf(box);
    const FaceLight worn = faceLight(small, drawPicture(renderer(), small), 0.4f, 0.5f);
    const FaceLight whole = faceLight(large, drawPicture(renderer(), large), 0.4f, 0.5f);
    EXPECT_NEAR(worn.inside, whole.inside, 1);
    EXPECT_GT(std::abs(worn.rim - whole.rim), 5) << worn.rim << ", " << whole.rim;
}

TEST_F(RoundColliders, FillTheirSilhouettesAndNothingElse) {
    for (const ColliderDraw& solid : {ball(), rod()}) {
        const Scene scene = sceneOf(solid);
        const std::vector<uint32_t> ids = idsOf(scene);
        size_t seen = 0, errors = 0;
        for (int y = 0; y < scene.view.height; ++y)
            for (int x = 0; x < scene.view.width; ++x) {
                const Ray ray = pixelRay(scene.view.camera, scene.view.width, scene.view.height,
                                         static_cast<float>(x), static_cast<float>(y));
                const float distance = lineToLine(solid, ray), radius = solid.half_size.x;
                if (std::abs(distance - radius) < 0.02f) continue;
                const bool is_solid = ids[static_cast<size_t>(y) * scene.view.width + x] == kColliderId;
                seen += is_solid;
                errors += is_solid != (distance < radius);
            }
        EXPECT_EQ(errors, 0u);
        EXPECT_GT(seen, 1000u);
    }
}

TEST_F(RoundColliders, StandOnEveryFloorInEveryQuality) {
    for (const FloorMaterial floor :
         {FloorMaterial::kChecker, FloorMaterial::kConcrete, FloorMaterial::kPlanks, FloorMaterial::kGrid,
          FloorMaterial::kSweep, FloorMaterial::kShadow, FloorMaterial::kNone})
        for (const RenderQuality quality : {RenderQuality::kDraft, RenderQuality::kFull}) {
            Scene scene = sceneOf(ball());
            scene.view.lighting.floor = floor;
            scene.view.quality = quality;
            EXPECT_NO_THROW(drawPicture(renderer(), scene));
        }
}

/// Twelve triangles, one unit to each side of the origin.
std::shared_ptr<const ColliderTriangles> unitCube() {
    auto triangles = std::make_shared<ColliderTriangles>();
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f})
            for (const auto& [u, v] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
                glm::vec3 p, n(0);
                n[axis] = p[axis] = side;
                p[(axis + 1) % 3] = static_cast<float>(u) * side;
                p[(axis + 2) % 3] = static_cast<float>(v);
                for (const glm::vec3& of : {p, n}) triangles->insert(triangles->end(), {of.x, of.y, of.z});
            }
    return triangles;
}

/// As cables are: the same place on the picture as the box of those sides, of another material.
TEST_F(RoundColliders, TrianglesAreStretchedAlongTheirAxesAndMayBeOfSteel) {
    ColliderDraw box = rod();
    box.shape = ColliderShape::kBox;
    box.half_size = {0.08f, 0.2f, 0.6f};
    ColliderDraw stretched = box;
    stretched.triangles = unitCube();
    const std::vector<uint32_t> of_box = idsOf(sceneOf(box)), of_triangles = idsOf(sceneOf(stretched));
    size_t seen = 0, unlike = 0;
    for (size_t p = 0; p < of_box.size(); ++p) {
        seen += of_box[p] == kColliderId;
        unlike += of_box[p] != of_triangles[p];
    }
    EXPECT_GT(seen, 500u);
    EXPECT_LT(unlike, seen / 50) << "but for pixels on its edges";
    EXPECT_LT(differingPixels(drawPicture(renderer(), sceneOf(box)),
                              drawPicture(renderer(), sceneOf(stretched)), 12),
              seen / 5)
        << "lit as the box is";
    ColliderDraw steel = stretched;
    steel.is_steel = true;
    EXPECT_GT(differingPixels(drawPicture(renderer(), sceneOf(steel)),
                              drawPicture(renderer(), sceneOf(stretched)), 8),
              seen / 2);
}

/// A shape, and triangles; nothing else changes.
TEST_F(RoundColliders, AreOfTheirOwnColour) {
    ColliderDraw box = rod();
    box.shape = ColliderShape::kBox;
    for (const bool of_triangles : {false, true}) {
        if (of_triangles) box.triangles = unitCube();
        ColliderDraw red = box;
        red.colour = glm::vec3(0.6f, 0.02f, 0.02f);
        const Image grey_picture = drawPicture(renderer(), sceneOf(box)),
                    red_picture = drawPicture(renderer(), sceneOf(red));
        const std::vector<uint32_t> ids = idsOf(sceneOf(box));
        size_t seen = 0, reds = 0, others = 0;
        for (size_t p = 0; p < ids.size(); ++p) {
            const uint8_t *with = &red_picture.pixels[4 * p], *without = &grey_picture.pixels[4 * p];
            seen += ids[p] == kColliderId;
            reds += ids[p] == kColliderId && with[0] > 2 * with[1];
            others += ids[p] == kBackgroundId && with[0] != without[0];
        }
        EXPECT_GT(reds, seen * 9 / 10);
        EXPECT_EQ(others, 0u);
    }
}

/// Floor that the solid hides from the sun is darker, the rest as it was; the side towards the sun shows no
/// stripes of its own shadow.
TEST_F(RoundColliders, ShadeTheFloorAndNotThemselves) {
    for (const ColliderDraw& solid : {ball(), rod()})
        for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
            Scene scene = sceneOf(solid);
            scene.view.quality = quality;
            const Image with = drawPicture(renderer(), scene);
            const std::vector<uint32_t> ids = idsOf(scene);
            scene.view.colliders.clear();
            const Image without = drawPicture(renderer(), scene);
            const glm::vec3 to_sun = -glm::normalize(scene.view.lighting.sun_direction);
            size_t dark = 0, dark_wrong = 0, lit_wrong = 0, stripes = 0;
            for (int y = 2; y + 2 < scene.view.height; ++y)
                for (int x = 2; x + 2 < scene.view.width; ++x) {
                    const auto bright = [&](const Image& image, int dx) {
                        const uint8_t* p = image.at(x + dx, y);
                        return (p[0] + p[1] + p[2]) / 3;
                    };
                    const uint32_t* id = &ids[static_cast<size_t>(y) * scene.view.width + x];
                    if (std::all_of(id - 2, id + 3, [](uint32_t i) { return i == kColliderId; }))
                        stripes += std::abs(2 * bright(with, 0) - bright(with, -1) - bright(with, 1)) > 24;
                    if (std::any_of(id - 2, id + 3, [](uint32_t i) { return i != kFloorId; })) continue;
                    const Ray ray = pixelRay(scene.view.camera, scene.view.width, scene.view.height,
                                             static_cast<float>(x), static_cast<float>(y));
                    const glm::vec3 p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
                    if (std::max(std::abs(p.x), std::abs(p.z)) > 4.0f) continue;
                    const float distance = lineToLine(solid, {p, to_sun});
                    const int loss = bright(without, 0) - bright(with, 0);
                    dark += distance < solid.half_size.x - 0.1f;
                    dark_wrong += distance < solid.half_size.x - 0.1f && loss < 25;
                    lit_wrong += distance > solid.half_size.x + 0.35f && std::abs(loss) > 6;
                }
            EXPECT_GT(dark, 200u);
            EXPECT_EQ(dark_wrong, 0u);
            EXPECT_EQ(lit_wrong, 0u);
            EXPECT_LT(stripes, 20u);
        }
}

/// Triangles of a mesh are seen where the shape that they are of is, and their shadow falls where its falls.
TEST_F(RoundColliders, TrianglesLookLikeTheBoxThatTheyAreOf) {
    ColliderDraw box;
    box.position = {0.1f, 0.45f, 0};
    box.rotation = glm::angleAxis(0.6f, glm::normalize(glm::vec3(0.2f, 1, 0.1f)));
    box.half_size = glm::vec3(0.4f);
    ColliderDraw mesh = box;
    ColliderTriangles triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0), u(0), v(0);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1;
            for (const glm::vec2 at : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
                const glm::vec3 p = normal + at.x * u + at.y * v;
                triangles.insert(triangles.end(), {p.x, p.y, p.z, normal.x, normal.y, normal.z});
            }
        }
    mesh.triangles = std::make_shared<const ColliderTriangles>(triangles);
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft}) {
        Scene shape = sceneOf(box), drawn = sceneOf(mesh);
        shape.view.quality = drawn.view.quality = quality;
        const auto a = idsOf(shape), b = idsOf(drawn);
        size_t other = 0;
        for (size_t k = 0; k < a.size(); ++k) other += a[k] != b[k];
        EXPECT_LT(other, 30u) << "along its outline";
        const Image expected = drawPicture(renderer(), shape);
        EXPECT_LT(differingPixels(expected, drawPicture(renderer(), drawn), 24), 600u);
        drawn.view.colliders.clear();
        EXPECT_GT(differingPixels(expected, drawPicture(renderer(), drawn), 24), 3000u);
    }
}

/// Their light changes from the top to the side: they are round.
TEST_F(RoundColliders, AreLitAllRound) {
    Scene scene = sceneOf(ball());
    const Image picture = drawPicture(renderer(), scene);
    const std::vector<uint32_t> ids = idsOf(scene);
    int darkest = 255, brightest = 0;
    for (size_t k = 0; k < ids.size(); ++k) {
        if (ids[k] != kColliderId) continue;
        const uint8_t* p = &picture.pixels[4 * k];
        darkest = std::min(darkest, (p[0] + p[1] + p[2]) / 3);
        brightest = std::max(brightest, (p[0] + p[1] + p[2]) / 3);
    }
    EXPECT_GT(brightest - darkest, 50);
}

}  // namespace
}  // namespace demolish::engine::test
