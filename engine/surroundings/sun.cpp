// SPDX-License-Identifier: Apache-2.0
// A sun is what shines much more than its surroundings within a few degrees of the brightest texel.
#include "engine/surroundings/sun.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demolish::engine {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
/// Half the angle of the cone in which a sun's or a lamp's light is gathered, and of the ring round it that
/// says what is behind it.
const float kLampCosine = std::cos(0.22f), kRingCosine = std::cos(0.32f);
/// A sun gives at least this share of the light of its half of the picture.
constexpr float kLeastShare = 0.08f;
/// Of the narrowest light that shadows are drawn for, and of the widest.
constexpr float kLeastTangent = 0.012f, kMostTangent = 0.2f;

/// Averaged over a degree: one hot texel of a noisy picture is not the sun.
RadiancePicture smoothed(const RadiancePicture& picture) {
    RadiancePicture small = picture;
    while (small.width > 512) small = halved(small);
    return small;
}

glm::vec3 brightestDirection(const RadiancePicture& picture) {
    glm::vec3 best(0, 1, 0);
    float most = -1;
    for (int y = 0; y < picture.height / 2; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (const float l = luminance(picture.at(x, y)); l > most) {
                most = l;
                best = picture.direction(x, y);
            }
    return best;
}

/// Mean radiance of the ring, by solid angle.
glm::vec3 ringRadiance(const RadiancePicture& picture, glm::vec3 towards) {
    glm::vec3 sum(0);
    float weights = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float cosine = glm::dot(picture.direction(x, y), towards);
            if (cosine > kLampCosine || cosine < kRingCosine) continue;
            sum += picture.solidAngle(y) * picture.at(x, y);
            weights += picture.solidAngle(y);
        }
    return weights > 0 ? sum / weights : glm::vec3(0);
}

/// What each texel shines with beyond what is behind the lamp.
struct Excess {
    glm::vec3 irradiance{0}, moment{0};
    float spread = 0;  ///< of the angle's square, weighted by luminance
};

Excess excessOf(const RadiancePicture& picture, glm::vec3 towards, glm::vec3 behind) {
    Excess excess;
    float weights = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 direction = picture.direction(x, y);
            const float cosine = glm::dot(direction, towards);
            if (cosine < kLampCosine) continue;
            const glm::vec3 more = glm::max(picture.at(x, y) - behind, glm::vec3(0)) * picture.solidAngle(y);
            excess.irradiance += more;
            excess.moment += luminance(more) * direction;
            excess.spread += luminance(more) * std::max(0.0f, 2 - 2 * cosine);
            weights += luminance(more);
        }
    excess.spread = weights > 0 ? excess.spread / weights : 0;
    return excess;
}

/// Luminous irradiance of the upper half on whatever faces it.
float halfSpaceLight(const RadiancePicture& picture) {
    float sum = 0;
    for (int y = 0; y < picture.height / 2; ++y)
        for (int x = 0; x < picture.width; ++x) sum += picture.solidAngle(y) * luminance(picture.at(x, y));
    return sum;
}

void takeAway(RadiancePicture& picture, glm::vec3 towards, glm::vec3 behind) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (glm::dot(picture.direction(x, y), towards) >= kLampCosine)
                picture.at(x, y) = glm::min(picture.at(x, y), behind);
}

}  // namespace

std::optional<Sun> takeSun(RadiancePicture& picture) {
    const RadiancePicture small = smoothed(picture);
    const glm::vec3 brightest = brightestDirection(small);
    const glm::vec3 behind = ringRadiance(small, brightest);
    const Excess first = excessOf(small, brightest, behind);
    if (luminance(first.irradiance) < kLeastShare * halfSpaceLight(small) || glm::length(first.moment) <= 0)
        return std::nullopt;
    Sun sun;
    sun.towards = glm::normalize(first.moment);
    const Excess all = excessOf(small, sun.towards, behind);
    sun.colour = all.irradiance / kPi;
    // A disc of angle a has a mean square angle of a^2 / 2.
    sun.tangent = std::clamp(std::sqrt(2 * all.spread), kLeastTangent, kMostTangent);
    takeAway(picture, sun.towards, behind);
    return sun;
}

}  // namespace demolish::engine
