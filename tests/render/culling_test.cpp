// Triangles that are left out are never missed: the same picture, to the last bit, with and without them.
#include <glm/gtc/constants.hpp>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class Culling : public GlTest {
  protected:
    /// Draws the view with and without; returns how many triangles each gave to the rasteriser.
    static void expectSamePicture(Scene& scene) {
        scene.view.cull_triangles = false;
        const Image all = drawPicture(renderer(), scene);
        all_triangles_ = renderer().lastTriangles();
        scene.view.cull_triangles = true;
        const Image culled = drawPicture(renderer(), scene);
        culled_triangles_ = renderer().lastTriangles();
        EXPECT_TRUE(all.pixels == culled.pixels) << differingPixels(all, culled, 0) << " pixels differ";
    }
    static inline std::array<uint64_t, 3> all_triangles_, culled_triangles_;
};

Scene finelyCut(const std::string& name) {
    Scene scene = makeScene(name);
    scene.view.width = 320;
    scene.view.height = 180;
    return scene;
}

void turn(Camera& camera, float angle) {
    const glm::vec3 out = camera.eye - camera.target;
    const float c = std::cos(angle), s = std::sin(angle);
    camera.eye = camera.target + glm::vec3(c * out.x + s * out.z, out.y, c * out.z - s * out.x);
}

TEST_F(Culling, EverySceneFromEverySideIsTheSamePicture) {
    for (const char* name : {"cracked_block", "broken_block", "broken_ball"}) {
        Scene scene = finelyCut(name);
        for (int side = 0; side < 3; ++side) {
            SCOPED_TRACE(std::string(name) + ", side " + std::to_string(side));
            expectSamePicture(scene);
            turn(scene.view.camera, 0.3f + glm::two_pi<float>() / 3);
        }
    }
}

TEST_F(Culling, AnyNumberOfSamplesIsTheSamePicture) {
    Scene scene = finelyCut("broken_ball");
    for (const int samples : {1, 2, 4}) {
        SCOPED_TRACE(samples);
        scene.view.samples = samples;
        expectSamePicture(scene);
    }
}

TEST_F(Culling, SmallTrianglesFromAfarAreTheSamePicture) {
    Scene scene = finelyCut("broken_ball");
    const glm::vec3 out = scene.view.camera.eye - scene.view.camera.target;
    scene.view.camera.eye = scene.view.camera.target + 6.0f * out;
    expectSamePicture(scene);
    // Most cover no sample.
    EXPECT_LT(culled_triangles_[0], all_triangles_[0] / 4);
}

TEST_F(Culling, ACameraAmongThePiecesIsTheSamePicture) {
    Scene scene = finelyCut("broken_ball");
    scene.view.camera.eye = {0.4f, 0.6f, 0.3f};
    for (const float angle : {0.0f, 1.7f, 3.9f}) {
        SCOPED_TRACE(angle);
        scene.view.camera.target = scene.view.camera.eye + glm::vec3(std::cos(angle), -0.2f, std::sin(angle));
        expectSamePicture(scene);
    }
}

TEST_F(Culling, LeavesOutWhatFacesAwayAndWhatTheFarRegionCannotHold) {
    Scene scene = finelyCut("broken_ball");
    expectSamePicture(scene);
    EXPECT_LT(culled_triangles_[0], 6 * all_triangles_[0] / 10);
    EXPECT_LT(culled_triangles_[1], 6 * all_triangles_[1] / 10);
    EXPECT_LT(culled_triangles_[2], culled_triangles_[1]);
    EXPECT_GT(culled_triangles_[2], 0u);
}

TEST_F(Culling, DraftsDrawAll) {
    Scene scene = finelyCut("broken_ball");
    scene.view.quality = RenderQuality::kDraft;
    expectSamePicture(scene);
    EXPECT_EQ(culled_triangles_, all_triangles_);
    EXPECT_GT(all_triangles_[0], 0u);
}

}  // namespace
}  // namespace demolish::engine::test
