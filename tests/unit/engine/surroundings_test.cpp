// SPDX-License-Identifier: Apache-2.0
// Surroundings light as the picture that they are made of, and their sun is where it was painted.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/surroundings/own_surroundings.h"
#include "engine/surroundings/sky.h"

namespace demolish::engine {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
const std::vector<glm::vec3> kNormals = {{0, 1, 0},  {0, -1, 0},
                                         {1, 0, 0},  glm::normalize(glm::vec3(1, 2, -3)),
                                         {0, 0, -1}, glm::normalize(glm::vec3(-2, -1, 1))};

/// Mean radiance over the hemisphere about a normal, texel by texel.
glm::vec3 meanLight(const RadiancePicture& picture, glm::vec3 normal) {
    glm::vec3 sum(0);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            sum += std::max(0.0f, glm::dot(picture.direction(x, y), normal)) * picture.solidAngle(y) *
                   picture.at(x, y);
    return sum / kPi;
}

RadiancePicture withDisc(glm::vec3 towards, float radius, float radiance, float behind) {
    RadiancePicture picture(512, 256, glm::vec3(behind));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (glm::dot(picture.direction(x, y), towards) > std::cos(radius))
                picture.at(x, y) = glm::vec3(radiance, 0.9f * radiance, 0.8f * radiance);
    return picture;
}

TEST(Surroundings, UniformOnesLightEveryWayAlike) {
    const auto around = makeSurroundings(RadiancePicture(64, 32, {0.5f, 0.25f, 2}), std::nullopt);
    for (const glm::vec3 normal : kNormals) {
        const glm::vec3 light = evaluate(around->above, normal) + evaluate(around->below, normal);
        EXPECT_NEAR(light.x, 0.5f, 0.01f);
        EXPECT_NEAR(light.z, 2, 0.04f);
    }
    for (const glm::vec3 texel : around->mirrored.texels)
        ASSERT_LT(glm::length(texel - glm::vec3(0.5f, 0.25f, 2)), 1e-4f);
}

TEST(Surroundings, HarmonicsFollowASmoothPicture) {
    RadiancePicture picture(128, 64);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 d = picture.direction(x, y);
            picture.at(x, y) =
                glm::vec3(1 + 0.6f * d.x + 0.3f * d.y * d.z, 1 + d.y, 1 + 0.5f * (d.x * d.x - d.z * d.z));
        }
    const auto around = makeSurroundings(picture, std::nullopt);
    for (const glm::vec3 normal : kNormals) {
        const glm::vec3 light = evaluate(around->above, normal) + evaluate(around->below, normal);
        EXPECT_LT(glm::length(light - meanLight(picture, normal)), 0.04f);
    }
}

TEST(Surroundings, RoughLayersAreSmootherAndKeepTheMean) {
    RadiancePicture picture = withDisc(glm::normalize(glm::vec3(1, 1, 1)), 0.4f, 5, 0.2f);
    const auto around = makeSurroundings(picture, std::nullopt);
    const MirroredLayers& mirrored = around->mirrored;
    const size_t texels = static_cast<size_t>(mirrored.side) * static_cast<size_t>(mirrored.side);
    float last = 1e9f;
    for (int layer = 0; layer < mirrored.layers; ++layer) {
        float most = 0;
        for (size_t i = 0; i < texels; ++i)
            most = std::max(most, mirrored.texels[static_cast<size_t>(layer) * texels + i].x);
        EXPECT_LE(most, last * 1.02f) << layer;
        last = most;
    }
    EXPECT_LT(last, 2.5f);
    EXPECT_GT(last, 0.25f);
}

TEST(TheSun, IsTakenFromWhereItIsAndLeavesTheLightAsItWas) {
    for (const glm::vec3 place : {glm::vec3(1, 1, 1), glm::vec3(-3, 0.6f, 0.2f), glm::vec3(0.1f, 5, 0)}) {
        const glm::vec3 towards = glm::normalize(place);
        const RadiancePicture whole = withDisc(towards, 0.03f, 2000, 0.4f);
        RadiancePicture rest = whole;
        const std::optional<Sun> sun = takeSun(rest);
        ASSERT_TRUE(sun);
        EXPECT_GT(glm::dot(sun->towards, towards), std::cos(0.01f));
        EXPECT_NEAR(sun->tangent, 0.03f, 0.012f);
        for (const glm::vec3 normal : kNormals) {
            const glm::vec3 before = meanLight(whole, normal);
            const glm::vec3 after =
                meanLight(rest, normal) + std::max(0.0f, glm::dot(sun->towards, normal)) * sun->colour;
            EXPECT_NEAR(after.x, before.x, 0.03f * before.x + 0.01f);
        }
        for (const glm::vec3 texel : rest.texels) ASSERT_LT(texel.x, 0.5f);
    }
}

TEST(TheSun, IsNoneWhereNothingStandsOut) {
    RadiancePicture picture(64, 32, glm::vec3(1));
    EXPECT_FALSE(takeSun(picture));
    picture.at(5, 3) = glm::vec3(3);  // a lamp, but of hardly any light
    EXPECT_FALSE(takeSun(picture));
}

TEST(TheSun, TurnsWithThePicture) {
    RadiancePicture picture = turned(withDisc(glm::normalize(glm::vec3(0, 1, -1)), 0.05f, 900, 0.2f), 90);
    const std::optional<Sun> sun = takeSun(picture);
    ASSERT_TRUE(sun);
    EXPECT_GT(glm::dot(sun->towards, glm::normalize(glm::vec3(1, 1, 0))), std::cos(0.02f));
}

TEST(ClearSky, IsBlueAboveAndItsSunReddensAsItSinks) {
    float last = 0;
    for (const float height : {1.2f, 0.6f, 0.2f, 0.05f}) {
        const ClearSky sky = clearSky({std::cos(height), std::sin(height), 0});
        const float redness = sky.sun.colour.x / std::max(sky.sun.colour.z, 1e-6f);
        EXPECT_GT(redness, last);
        last = redness;
        const glm::vec3 zenith = sky.picture.sample({0, 1, 0});
        EXPECT_GT(zenith.z, zenith.x) << "at sun height " << height;
    }
    EXPECT_GT(last, 3);
}

TEST(OwnSurroundings, AreEvenlyBrightAndHaveASun) {
    for (const auto kind : {SurroundingsKind::kSky, SurroundingsKind::kStudio, SurroundingsKind::kOvercast}) {
        const auto around =
            makeSurroundings({.kind = kind, .to_sun = glm::normalize(glm::vec3(-0.5f, 0.7f, 0.5f))});
        ASSERT_TRUE(around->sun);
        float mean = 0;
        for (int y = 0; y < around->backdrop.height; ++y)
            for (int x = 0; x < around->backdrop.width; ++x) {
                const glm::vec3 texel = around->backdrop.at(x, y);
                ASSERT_TRUE(std::isfinite(texel.x) && texel.x >= 0 && texel.y >= 0 && texel.z >= 0);
                mean += around->backdrop.solidAngle(y) * luminance(texel) / (4 * kPi);
            }
        EXPECT_NEAR(mean + 0.25f * luminance(around->sun->colour), kEvenBrightness, 0.02f);
    }
}

}  // namespace
}  // namespace demolish::engine
