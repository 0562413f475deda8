// SPDX-License-Identifier: Apache-2.0
// Camera: matrices agree with rays, moves keep what they promise.
#include "engine/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/render/frame_uniforms.h"

namespace demolish::engine {
namespace {

TEST(Camera, DepthIsReversedFromNearToFar) {
    const Camera camera;
    const glm::mat4 projection = camera.projection(1.5f);
    const auto depth = [&](float distance) {
        const glm::vec4 clip = projection * glm::vec4(0, 0, -distance, 1);
        return clip.z / clip.w;
    };
    EXPECT_NEAR(depth(camera.near_plane), 1.0f, 1e-6f);
    EXPECT_NEAR(depth(camera.far_plane), 0.0f, 1e-6f);
    EXPECT_GT(depth(1.0f), depth(2.0f));
}

TEST(Camera, PixelRayMeetsThePointThatThePixelShows) {
    const Camera camera;
    constexpr int kWidth = 640, kHeight = 360;
    const glm::vec3 point(0.3f, 0.9f, -0.2f);
    const glm::vec4 clip =
        camera.projection(static_cast<float>(kWidth) / kHeight) * camera.view() * glm::vec4(point, 1);
    const float x = (clip.x / clip.w * 0.5f + 0.5f) * kWidth - 0.5f,
                y = (0.5f - clip.y / clip.w * 0.5f) * kHeight - 0.5f;
    const Ray ray = pixelRay(camera, kWidth, kHeight, x, y);
    EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(glm::cross(point - ray.origin, ray.direction)), 0.0f, 1e-5f);
}

TEST(Camera, AnUprightPictureShowsAsMuchAsAWideOne) {
    Camera camera;
    const glm::vec3 centre(0, 0.4f, 0);
    camera.frame(centre, 0.5f);
    for (const float aspect : {16.0f / 9, 1.0f, 9.0f / 16}) {
        const glm::mat4 seen = camera.projection(aspect) * camera.view();
        float most = 0;
        for (const glm::vec3 way : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
            for (const float side : {-0.5f, 0.5f}) {
                const glm::vec4 clip = seen * glm::vec4(centre + side * way, 1);
                most = std::max({most, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
            }
        EXPECT_LE(most, 1.0f) << aspect;
        EXPECT_GT(most, 0.6f) << aspect;
    }
    const Ray ray = pixelRay(camera, 90, 160, 89.5f, 79.5f);
    EXPECT_NEAR(glm::dot(ray.direction, glm::normalize(centre - camera.eye)),
                std::cos(0.5f * camera.field_of_view), 1e-5f);
}

TEST(Camera, OrbitKeepsDistanceAndNeverFlips) {
    Camera camera;
    const float distance = glm::distance(camera.eye, camera.target);
    for (int i = 0; i < 100; ++i) {
        camera.orbit(0.31f, 0.2f);
        EXPECT_NEAR(glm::distance(camera.eye, camera.target), distance, 1e-4f);
        const glm::mat4 view = camera.view();
        EXPECT_GT(view[1][1], 0.0f) << "world up must stay up";
        EXPECT_FALSE(std::isnan(view[0][0]));
    }
    for (int i = 0; i < 100; ++i) camera.orbit(0, -0.2f);
    EXPECT_LT(camera.eye.y, camera.target.y);
}

TEST(Camera, OrbitThereAndBackReturns) {
    Camera camera;
    const glm::vec3 eye = camera.eye;
    camera.orbit(0.4f, 0.1f);
    EXPECT_GT(glm::distance(eye, camera.eye), 0.1f);
    camera.orbit(-0.4f, -0.1f);
    EXPECT_NEAR(glm::distance(eye, camera.eye), 0.0f, 1e-5f);
}

TEST(Camera, PanMovesTheTargetByItsShareOfThePicture) {
    Camera camera;
    const Camera before = camera;
    camera.pan(0.0f, 0.25f);
    // The old target now stands a quarter of the picture's height below the middle.
    const glm::vec4 clip = camera.projection(1.0f) * camera.view() * glm::vec4(before.target, 1);
    EXPECT_NEAR(clip.y / clip.w, -0.5f, 1e-4f);
    EXPECT_NEAR(glm::distance(camera.eye, camera.target), glm::distance(before.eye, before.target), 1e-5f);
}

TEST(Camera, DollyScalesTheDistanceWithinLimits) {
    Camera camera;
    const float distance = glm::distance(camera.eye, camera.target);
    camera.dolly(0.5f);
    EXPECT_NEAR(glm::distance(camera.eye, camera.target), 0.5f * distance, 1e-5f);
    for (int i = 0; i < 50; ++i) camera.dolly(0.1f);
    EXPECT_GE(glm::distance(camera.eye, camera.target), camera.near_plane);
    for (int i = 0; i < 50; ++i) camera.dolly(10.0f);
    EXPECT_LE(glm::distance(camera.eye, camera.target), camera.far_plane);
    const glm::vec3 eye = camera.eye;
    camera.dolly(-1.0f);
    EXPECT_EQ(camera.eye, eye);
}

TEST(Camera, FrameMakesTheSphereTouchThePictureEdge) {
    Camera camera;
    const glm::vec3 centre(1, 2, 3);
    camera.frame(centre, 0.7f);
    EXPECT_EQ(camera.target, centre);
    EXPECT_NEAR(std::asin(0.7f / glm::distance(camera.eye, centre)), 0.5f * camera.field_of_view, 1e-5f);
}

template <class Matrix>
bool finite(const Matrix& matrix) {
    for (int column = 0; column < Matrix::length(); ++column)
        for (int row = 0; row < Matrix::col_type::length(); ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(Camera, NoPlaceAndNoAngleOfItGivesNumbersThatAreNone) {
    const glm::vec3 target(0.1f, 0.4f, -0.2f);
    for (const glm::vec3 away :
         {glm::vec3(0), glm::vec3(0, 2, 0), glm::vec3(0, -2, 0), glm::vec3(1e-30f, 0, 0)})
        for (const float angle : {0.0f, 0.7f, 3.15f, 7.0f}) {
            Camera camera;
            camera.target = target;
            camera.eye = target + away;
            camera.field_of_view = angle;
            EXPECT_TRUE(finite(camera.view()));
            EXPECT_NEAR(glm::determinant(glm::mat3(camera.view())), 1.0f, 1e-4f) << "turns, and no more";
            EXPECT_TRUE(finite(camera.projection(1.5f)));
            EXPECT_TRUE(finite(camera.projection(0.0f)));
            EXPECT_TRUE(finite(pixelRay(camera, 64, 48, 3, 4).direction));
            EXPECT_TRUE(finite(pixelRay(camera, 0, 0, 0, 0).direction));
            Camera moved = camera;
            moved.orbit(0.1f, 0.1f);
            moved.pan(0.1f, 0.1f);
            moved.dolly(2);
            EXPECT_TRUE(finite(moved.eye) && finite(moved.target));
            moved.frame(target, 0.5f);
            EXPECT_TRUE(finite(moved.eye) && finite(moved.target));
        }
}

TEST(Camera, LooksStraightDownOnWhatIsBelow) {
    Camera camera;
    camera.eye = glm::vec3(0, 3, 0);
    camera.target = glm::vec3(0);
    const glm::vec4 seen = camera.projection(1) * camera.view() * glm::vec4(0, 0, 0, 1);
    EXPECT_NEAR(seen.x, 0, 1e-5f);
    EXPECT_NEAR(seen.y, 0, 1e-5f);
    EXPECT_GT(seen.w, 0);
}

TEST(Camera, ItsUpTurnsThePictureAndGoesRoundWithIt) {
    Camera camera;
    camera.eye = {0, 0, 5};
    camera.target = {0, 0, 0};
    camera.up = {1, 0, 0};
    const auto on_screen = [&camera](glm::vec3 point) {
        const glm::vec4 clip = camera.projection(1) * camera.view() * glm::vec4(point, 1);
        return glm::vec2(clip.x, clip.y) / clip.w;
    };
    EXPECT_GT(on_screen({1, 0, 0}).y, 0.1f) << "what lies at +x is above";
    EXPECT_NEAR(on_screen({1, 0, 0}).x, 0, 1e-6f);
    EXPECT_LT(on_screen({0, 1, 0}).x, -0.1f);
    camera.orbit(static_cast<float>(M_PI / 2), 0);
    EXPECT_NEAR(glm::length(camera.up - glm::vec3(0, 0, -1)), 0, 1e-6f);
    EXPECT_GT(on_screen({0, 0, -1}).y, 0.1f);
    camera.up = camera.direction();
    EXPECT_TRUE(std::isfinite(camera.view()[0][0])) << "along the view it is of no use, and no harm";
    camera.up = glm::vec3(0);
    EXPECT_TRUE(std::isfinite(camera.view()[0][0]));
}

TEST(FrameUniforms, ASunWithoutADirectionStandsInTheZenith) {
    FrameView view;
    view.width = 64;
    view.height = 48;
    view.lighting.sun_direction = glm::vec3(0);
    EXPECT_EQ(glm::vec3(makeFrameUniforms(view, 1024).to_sun), glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace demolish::engine
