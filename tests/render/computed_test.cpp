// The body found in compute passes looks as it looks drawn, but for rounding at edges.
#include <cstdlib>
#include <glm/gtc/constants.hpp>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class Computed : public GlTest {
  protected:
    static void expectSameLook(Scene& scene) { expectSameLook(scene, renderer()); }

    static void expectSameLook(Scene& scene, Renderer& computing) {
        scene.view.rasteriser = Rasteriser::kDraw;
        const Image drawn = drawPicture(renderer(), scene);
        scene.view.rasteriser = Rasteriser::kCompute;
        const Image computed = drawPicture(computing, scene);
        const size_t differing = differingPixels(drawn, computed, 5);
        const auto pixels = static_cast<double>(drawn.width * drawn.height);
        EXPECT_LE(static_cast<double>(differing), 0.005 * pixels);
        EXPECT_LE(static_cast<double>(differingPixels(drawn, computed, 32)), 0.001 * pixels);
        if (const char* folder = std::getenv("COMPUTED_OUT")) {
            static int number = 0;
            const std::string base = std::string(folder) + "/" + std::to_string(number++);
            writePng(base + "_drawn.png", drawn);
            writePng(base + "_computed.png", computed);
            std::printf("%s: %zu of %.0f differ by more than 5, %zu by more than 32\n", base.c_str(),
                        differing, pixels, differingPixels(drawn, computed, 32));
        }
    }
};

Scene small(const std::string& name) {
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

TEST_F(Computed, EverySceneFromEverySide) {
    for (const char* name : {"whole_block", "cracked_block", "broken_block", "broken_ball"}) {
        Scene scene = small(name);
        for (int side = 0; side < 3; ++side) {
            SCOPED_TRACE(std::string(name) + ", side " + std::to_string(side));
            expectSameLook(scene);
            turn(scene.view.camera, 0.3f + glm::two_pi<float>() / 3);
        }
    }
}

TEST_F(Computed, AnyNumberOfSamples) {
    Scene scene = small("broken_ball");
    for (const int samples : {1, 2, 4}) {
        SCOPED_TRACE(samples);
        scene.view.samples = samples;
        expectSameLook(scene);
    }
}

TEST_F(Computed, SmallTrianglesFromAfar) {
    Scene scene = small("broken_ball");
    const glm::vec3 out = scene.view.camera.eye - scene.view.camera.target;
    scene.view.camera.eye = scene.view.camera.target + 6.0f * out;
    expectSameLook(scene);
}

TEST_F(Computed, ACameraAmongThePieces) {
    Scene scene = small("broken_ball");
    scene.view.camera.eye = {0.4f, 0.6f, 0.3f};
    for (const float angle : {0.0f, 1.7f, 3.9f}) {
        SCOPED_TRACE(angle);
        scene.view.camera.target = scene.view.camera.eye + glm::vec3(std::cos(angle), -0.2f, std::sin(angle));
        expectSameLook(scene);
    }
}

TEST_F(Computed, TooManyLargeTrianglesForTheirMemory) {
    Renderer poor(shaderFolder(), 10);
    Scene scene = small("broken_block");
    expectSameLook(scene, poor);
}

}  // namespace
}  // namespace demolish::engine::test
