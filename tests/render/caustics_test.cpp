// SPDX-License-Identifier: Apache-2.0
// Where light of the sun arrives that bodies have bent, which are given as the sun's map has them.
#include "engine/passes/caustics_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/render/frame_uniforms.h"
#include "tests/render/gl_fixture.h"

namespace demolish::engine::test {
namespace {

constexpr int kMapTexels = 1024, kTexels = CausticsPass::kTexels;
constexpr float kRadius = 0.1f;           ///< m, of the ball; of the scene: 1 m
constexpr float kSquare = 0.96f * 0.96f;  ///< of the light is left by two faces square to it

/// A ray's way in a body, in m along the light from the middle of the sun's map; in > out: there is none.
struct Chord {
    float in, out;
};
using ChordAt = std::function<Chord(glm::vec2 across)>;  ///< of m from the middle of the map

Chord ball(glm::vec2 across) {
    const float square = kRadius * kRadius - glm::dot(across, across);
    return square > 0 ? Chord{-std::sqrt(square), std::sqrt(square)} : Chord{1, -1};
}

class Caustics : public GlTest {
  protected:
    /// Light on the floor, red, by texel; of clear glass but for `absorption`, 1/m. The middle of the map is
    /// at `middle`.
    std::vector<float> cast(const ChordAt& chord, glm::vec3 middle, float absorption = 0) {
        FrameView view;
        view.width = view.height = 16;
        view.scene_radius = 1;
        for (int k = 0; k < 3; ++k) view.scene_centre[k] = middle[k];
        view.lighting.sun_direction = sun_direction_;
        view.look.refraction_index = 1.5f;
        view.look.absorption[0] = absorption;
        frame_ = makeFrameUniforms(view, 2048);
        const gl::Buffer block = gl::Buffer::immutable(sizeof(frame_), &frame_);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, block.id());
        std::vector<glm::vec2> sums(size_t{kMapTexels} * kMapTexels), ends(sums.size());
        for (int y = 0; y < kMapTexels; ++y)
            for (int x = 0; x < kMapTexels; ++x) {
                const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / float{kMapTexels};
                const Chord way = chord((uv - 0.5f) * frame_.shadow[0].z);
                const size_t at = size_t{kMapTexels} * static_cast<size_t>(y) + static_cast<size_t>(x);
                const bool any = way.in < way.out;
                const float depth = frame_.shadow[0].w;
                sums[at] = any ? glm::vec2(way.out - way.in, 0) : glm::vec2(0);
                ends[at] = any ? glm::vec2(0.5f - way.in / depth, 0.5f + way.out / depth) : glm::vec2(-1000);
            }
        const gl::Texture sum_map = mapOf(sums), end_map = mapOf(ends);
        CausticsPass pass(shaderFolder());
        pass.cast(sum_map, end_map);
        std::vector<glm::vec4> light(size_t{kTexels} * kTexels);
        glGetTextureImage(pass.light().id(), 0, GL_RGBA, GL_FLOAT,
                          static_cast<GLsizei>(sizeof(light[0]) * light.size()), light.data());
        std::vector<float> red;
        for (const glm::vec4& texel : light) red.push_back(texel.r);
        return red;
    }
    static float at(const std::vector<float>& light, int x, int y) {
        return light[static_cast<size_t>(y) * kTexels + static_cast<size_t>(x)];
    }
    glm::vec3 toSun() const { return frame_.to_sun; }
    FrameUniforms frame_{};
    glm::vec3 sun_direction_ = Lighting().sun_direction;

  private:
    static gl::Texture mapOf(const std::vector<glm::vec2>& texels) {
        gl::Texture map = gl::Texture::make2d(GL_RG32F, kMapTexels, kMapTexels, 5);
        map.uploadPart(0, 0, kMapTexels, kMapTexels, GL_RG, GL_FLOAT, texels.data(), kMapTexels);
        map.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
        glGenerateTextureMipmap(map.id());
        return map;
    }
};

/// What is missing of the light of all texels.
double missing(const std::vector<float>& light) {
    double sum = 0;
    for (const float texel : light) sum += 1 - texel;
    return sum;
}

/// m^2 of the sun's map in a texel of the light.
constexpr double kTexelArea = 4.0 / (double{kTexels} * kTexels);

TEST_F(Caustics, APaneBendsNothing) {
    const auto pane = [](glm::vec2 across) {
        return std::max(std::abs(across.x), std::abs(across.y)) < 0.3f ? Chord{-0.05f, 0.05f} : Chord{1, -1};
    };
    const std::vector<float> light = cast(pane, {0, 0.8f, 0}, 4);
    const float through = kSquare * std::exp(-4 * 0.1f);
    for (const int x : {200, 230, 256, 300}) EXPECT_NEAR(at(light, x, 256 + x / 8), through, 2e-3f) << x;
    for (const int x : {100, 170, 350, 500}) EXPECT_NEAR(at(light, x, 256), 1, 1e-3f) << x;
    EXPECT_NEAR(missing(light) * kTexelArea, 0.36 * (1 - through), 0.03 * 0.36);
}

/// A slanting pane shifts its light a little, and loses none of it.
TEST_F(Caustics, ASlantingPaneLetsThroughAsMuch) {
    const auto pane = [](glm::vec2 across) {
        const float at = 0.5f * across.x;
        return glm::length(across) < 0.3f ? Chord{at - 0.02f, at + 0.02f} : Chord{1, -1};
    };
    const std::vector<float> light = cast(pane, {0, 0.8f, 0});
    EXPECT_NEAR(at(light, 256, 256), kSquare, 0.01f);
    EXPECT_NEAR(missing(light) * kTexelArea, 0.283 * (1 - kSquare), 0.03 * 0.283);
}

/// Rays near the axis of a ball of index 1.5 meet one and a half radii behind its middle.
TEST_F(Caustics, ABallGathersLightInItsFocus) {
    cast(ball, {});
    const glm::vec3 middle = 1.5f * kRadius * toSun();
    const std::vector<float> light = cast(ball, middle);
    glm::ivec2 brightest{};
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x)
            if (at(light, x, y) > at(light, brightest.x, brightest.y)) brightest = {x, y};
    EXPECT_NEAR(brightest.x, 255.5, 1.5);
    EXPECT_NEAR(brightest.y, 255.5, 1.5);
    EXPECT_GT(at(light, brightest.x, brightest.y), 20);
    EXPECT_LT(at(light, 256 + 20, 256), 0.5f);  // in its shadow, beside the focus
    EXPECT_NEAR(at(light, 256 + 150, 256), 1, 0.02f);
}

/// All that it lets through arrives somewhere: under a sun that stands high, nearly all within the map.
TEST_F(Caustics, ABallLosesNoLight) {
    sun_direction_ = {0, -1, 0};
    double lost = 0;  // by mirroring where rays enter and leave, which they do at the same angle
    constexpr int kRings = 1000;
    for (int k = 0; k < kRings; ++k) {
        const double b = (k + 0.5) / kRings, steep = std::sqrt(1 - b * b);
        const double left = 1 - std::min(0.04 + 0.96 * std::pow(1 - steep, 5.0), 0.95);
        const double bent = 2 * (std::asin(b) - std::asin(b / 1.5));
        const bool leaves_map = 1.5 * kRadius * std::tan(bent) > 1;
        lost += 2 * b / kRings * (leaves_map ? 1 : 1 - left * left);
    }
    const double disc = 3.14159265 * kRadius * kRadius;
    EXPECT_NEAR(missing(cast(ball, {0, 1.5f * kRadius, 0})) * kTexelArea / disc, lost, 0.03);
}

/// The same ball farther from the floor spreads its light wider.
TEST_F(Caustics, OutOfFocusIsDimmer) {
    cast(ball, {});
    const auto most = [&](float radii) {
        const std::vector<float> light = cast(ball, radii * kRadius * toSun());
        return *std::max_element(light.begin(), light.end());
    };
    const float focus = most(1.5f);
    EXPECT_LT(most(2.5f), 0.7f * focus);
    EXPECT_LT(most(4), 0.3f * focus);
}

/// What moves by less than a texel neither flashes nor fades.
TEST_F(Caustics, AreSteadyInMotion) {
    cast(ball, {});
    const glm::vec3 middle = 2.0f * kRadius * toSun();
    float least = 1e9f, most = 0;
    for (int step = 0; step < 6; ++step) {
        const glm::vec2 shift = static_cast<float>(step) / (3.0f * kTexels) * glm::vec2(1, 0.4f);
        const std::vector<float> light = cast([&](glm::vec2 across) { return ball(across - shift); }, middle);
        const float brightest = *std::max_element(light.begin(), light.end());
        least = std::min(least, brightest);
        most = std::max(most, brightest);
    }
    EXPECT_LT(most, 1.15f * least);
}

TEST_F(Caustics, AreTheSameEveryTime) {
    const glm::vec3 middle(0, 0.3f, 0);
    EXPECT_EQ(cast(ball, middle), cast(ball, middle));
}

}  // namespace
}  // namespace demolish::engine::test
