// SPDX-License-Identifier: Apache-2.0
// What a surface does with light, beside the integrals that its formulas stand for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/surroundings/surroundings.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

using BrdfTest = GlTest;

struct Ring {
    double light = 0;
    int pixels = 0;
    double mean() const { return light / pixels; }
};
/// Of a ball's disc, by how much its surface faces the camera: ten rings of the cosine.
std::array<Ring, 10> ringsOf(const Image& picture, const std::vector<uint32_t>& ids) {
    const int width = picture.width;
    int low_x = width, high_x = 0, low_y = picture.height, high_y = 0;
    const auto eachOfBody = [&](const auto& use) {
        for (size_t i = 0; i < ids.size(); ++i)
            if (isBody(ids[i])) use(static_cast<int>(i) % width, static_cast<int>(i) / width, i);
    };
    eachOfBody([&](int x, int y, size_t) {
        low_x = std::min(low_x, x), high_x = std::max(high_x, x);
        low_y = std::min(low_y, y), high_y = std::max(high_y, y);
    });
    const double middle_x = 0.5 * (low_x + high_x), middle_y = 0.5 * (low_y + high_y),
                 radius = 0.25 * (high_x - low_x + high_y - low_y + 2);
    std::array<Ring, 10> rings;
    eachOfBody([&](int x, int y, size_t i) {
        const double away = std::hypot(x - middle_x, y - middle_y) / radius;
        if (away >= 1) return;
        Ring& ring = rings[std::min(9, static_cast<int>(10 * std::sqrt(1 - away * away)))];
        ring.light += static_cast<double>(decoded(picture.pixels[4 * i + 1]));
        ++ring.pixels;
    });
    return rings;
}

/// Share of light from all around that a GGX surface mirrors at an f0 of 0.04, by an integral over the half
/// vectors.
double mirroredShare(double roughness, double n_dot_v) {
    constexpr int kSlopes = 64, kTurns = 64;
    const double alpha2 = std::pow(roughness, 4), v_x = std::sqrt(1 - n_dot_v * n_dot_v);
    double sum = 0;
    for (int i = 0; i < kSlopes; ++i)
        for (int k = 0; k < kTurns; ++k) {
            const double u = (i + 0.5) / kSlopes, turn = 2 * std::numbers::pi * (k + 0.5) / kTurns;
            const double h_z = std::sqrt((1 - u) / (1 + (alpha2 - 1) * u));
            const double v_dot_h = v_x * std::sqrt(1 - h_z * h_z) * std::cos(turn) + n_dot_v * h_z;
            const double l_z = 2 * v_dot_h * h_z - n_dot_v;
            if (l_z <= 0 || v_dot_h <= 0) continue;
            const double masking = l_z * std::sqrt(n_dot_v * n_dot_v * (1 - alpha2) + alpha2),
                         shadowing = n_dot_v * std::sqrt(l_z * l_z * (1 - alpha2) + alpha2);
            const double fresnel = 0.04 + 0.96 * std::pow(1 - v_dot_h, 5);
            sum += fresnel * 2 * l_z * v_dot_h / (h_z * (masking + shadowing));
        }
    return sum / (kSlopes * kTurns);
}

TEST_F(BrdfTest, ARoughBallMirrorsWhatTheIntegralSays) {
    constexpr float kAlbedo = 0.03f, kRadiance = 2;
    for (const float roughness : {0.3f, 0.62f, 0.85f}) {
        Scene scene = greyBall(kAlbedo, roughness);
        putIntoFurnace(scene.view, glm::vec3(kRadiance));
        const auto rings =
            ringsOf(drawPicture(renderer(), scene), renderer().fragmentIds(scene.mesh.get(), {}, scene.view));
        for (const int ring : {2, 4, 6, 9}) {
            const double share = mirroredShare(roughness, (ring + 0.5) / 10);
            EXPECT_NEAR(rings[ring].mean() / kRadiance, kAlbedo * (1 - share) + share, 0.01);
        }
    }
}

/// Burley's law with the sun behind the camera, where both graze. From so far that rays are nearly parallel.
TEST_F(BrdfTest, ARoughBallIsFlatterInTheSunThanALambertianOne) {
    constexpr float kAlbedo = 0.5f;
    Scene scene = greyBall(kAlbedo, 0.9f);
    Camera& camera = scene.view.camera;
    camera.eye = camera.target + 12.0f * (camera.eye - camera.target);
    camera.field_of_view /= 12;
    putIntoFurnace(scene.view, glm::vec3(0));
    scene.view.lighting.sun_colour = glm::vec3(0.8f);
    scene.view.lighting.sun_direction = glm::normalize(camera.target - camera.eye);
    const auto rings =
        ringsOf(drawPicture(renderer(), scene), renderer().fragmentIds(scene.mesh.get(), {}, scene.view));
    for (const int ring : {2, 3, 5, 8}) {
        const double c = (ring + 0.5) / 10, grazed = 2 * 0.9 - 0.5;
        const double law = c * std::pow(1 + grazed * std::pow(1 - c, 5), 2);
        EXPECT_NEAR(rings[ring].mean() / rings[9].mean(), law / 0.95, 0.05) << ring;
    }
}

}  // namespace
}  // namespace demolish::engine::test
