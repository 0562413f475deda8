// SPDX-License-Identifier: Apache-2.0
// The pictures that a frame is averaged of: what is in focus stays, the rest moves over its circle of
// confusion.
#include "engine/scene/lens.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/render/frame_uniforms.h"

namespace demolish::engine {
namespace {

constexpr uint32_t kPictures = 64;

FrameView makeView() {
    FrameView view;
    view.width = 640;
    view.height = 360;
    return view;
}

/// Where a point lands, px from the left and from below.
glm::vec2 pixelOf(const FrameView& view, glm::vec3 point) {
    const glm::vec4 clip = makeFrameUniforms(view, 1024).view_projection * glm::vec4(point, 1);
    return (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(view.width, view.height);
}

TEST(Lens, TakesAsManyPicturesAsItNeeds) {
    EXPECT_EQ(picturesOf({}), 1u);
    EXPECT_EQ(picturesOf({.shutter = 0.5f}), 16u);
    EXPECT_EQ(picturesOf({.aperture = 2}), 16u);
    EXPECT_EQ(picturesOf({.shutter = 0.5f, .samples = 5}), 5u);
}

TEST(Lens, WhatIsInFocusStaysWithinItsPixel) {
    const FrameView frame = makeView();
    const Lens lens{.aperture = 1.4f};
    const glm::vec3 sharp = frame.camera.target;
    const glm::vec2 middle = pixelOf(frame, sharp);
    for (uint32_t i = 0; i < kPictures; ++i) {
        const glm::vec2 moved = pixelOf(pictureView(frame, lens, i, kPictures), sharp) - middle;
        EXPECT_LE(std::max(std::abs(moved.x), std::abs(moved.y)), 0.505f);
    }
}

TEST(Lens, WhatIsOutOfFocusFillsItsCircle) {
    const FrameView frame = makeView();
    const Lens lens{.aperture = 1.4f};
    const Camera& camera = frame.camera;
    const float focus = glm::length(camera.target - camera.eye);
    const glm::vec3 far = camera.eye + 3.0f * (camera.target - camera.eye);
    const glm::vec2 middle = pixelOf(frame, far);
    // Similar triangles: the circle on the plane of focus is (3 - 1) / 3 of the opening.
    const float on_plane = apertureRadius(lens, camera) * 2 / 3;
    const float aspect = 640.0f / 360;
    const float wanted = on_plane / focus / camera.halfHeight(aspect) * 180;
    float widest = 0;
    for (uint32_t i = 0; i < kPictures; ++i)
        widest = std::max(widest, glm::length(pixelOf(pictureView(frame, lens, i, kPictures), far) - middle));
    EXPECT_NEAR(widest, wanted, 1.0f + 0.05f * wanted);
    EXPECT_GT(wanted, 1);
}

TEST(Lens, RaysAndMatricesAgree) {
    const FrameView view = pictureView(makeView(), {.aperture = 1}, 3, 16);
    const FrameUniforms frame = makeFrameUniforms(view, 1024);
    const glm::vec3 point(0.3f, 0.9f, -0.2f);
    const glm::vec2 ndc = 2.0f * pixelOf(view, point) / glm::vec2(view.width, view.height) - 1.0f;
    const glm::vec3 ray = glm::vec3(frame.ray_forward + ndc.x * frame.ray_right + ndc.y * frame.ray_up);
    const glm::vec3 away = point - glm::vec3(frame.eye);
    EXPECT_LT(glm::length(glm::cross(glm::normalize(ray), away)), 1e-5f);
}

TEST(Lens, MomentsFillTheOpenShutterAndEndWithTheFrame) {
    const Lens lens{.shutter = 0.5f};
    float sum = 0;
    for (uint32_t i = 0; i < kPictures; ++i) {
        const float moment = pictureMoment(lens, i, kPictures);
        EXPECT_GT(moment, 0.5f);
        EXPECT_LT(moment, 1);
        sum += moment;
    }
    EXPECT_NEAR(sum / kPictures, 0.75f, 1e-4f);
    EXPECT_EQ(pictureMoment({}, 3, 16), 1);
}

}  // namespace
}  // namespace demolish::engine
