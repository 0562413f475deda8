// SPDX-License-Identifier: Apache-2.0
// Rayleigh and Mie scattering with ozone, integrated along each ray (Nishita et al. 1993; coefficients of
// Bruneton and Neyret 2008). Light that was scattered before is taken to come alike from all sides.
#include "engine/surroundings/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demolish::engine {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kGround = 6360, kTop = 6440;               // km, radii
const glm::vec3 kRayleigh(5.80e-3f, 13.56e-3f, 33.1e-3f);  // 1/km at sea level
const glm::vec3 kOzone(0.65e-3f, 1.88e-3f, 0.085e-3f);
constexpr float kMie = 5.0e-3f, kMieAbsorbed = 1.3e-3f;  // of a clear summer day
constexpr float kRayleighHeight = 8, kMieHeight = 1.2f;  // km, over which density falls to 1/e
constexpr float kForward = 0.76f;                        // mean cosine of Mie scattering
constexpr float kGroundAlbedo = 0.2f;
/// Thin high clouds, which photographers wait for: this share of the sun's light on level ground comes evenly
/// from all over the sky. Without them shadows are deeper and bluer.
constexpr float kVeil = 0.08f;
constexpr int kSteps = 24, kSunSteps = 8, kBounces = 3;
constexpr int kWidth = 256, kHeight = 128, kCoarse = 16;

struct Air {
    glm::vec3 rayleigh;
    float mie;
    glm::vec3 extinction;
};

Air airAt(float height) {
    Air air;
    air.rayleigh = kRayleigh * std::exp(-height / kRayleighHeight);
    air.mie = kMie * std::exp(-height / kMieHeight);
    const float ozone = std::max(0.0f, 1 - std::abs(height - 25) / 15);
    air.extinction = air.rayleigh + glm::vec3(air.mie * (1 + kMieAbsorbed / kMie)) + kOzone * ozone;
    return air;
}

/// To where a ray leaves the sphere, km.
float distanceTo(float radius, glm::vec3 from, glm::vec3 direction) {
    const float along = glm::dot(from, direction);
    return -along + std::sqrt(std::max(0.0f, along * along - glm::dot(from, from) + radius * radius));
}

bool hitsGround(glm::vec3 from, glm::vec3 direction) {
    const float along = glm::dot(from, direction);
    return along < 0 && along * along > glm::dot(from, from) - kGround * kGround;
}

glm::vec3 throughAir(glm::vec3 from, glm::vec3 direction) {
    if (hitsGround(from, direction)) return glm::vec3(0);
    const float step = distanceTo(kTop, from, direction) / kSunSteps;
    glm::vec3 depth(0);
    for (int i = 0; i < kSunSteps; ++i) {
        const glm::vec3 p = from + (static_cast<float>(i) + 0.5f) * step * direction;
        depth += step * airAt(glm::length(p) - kGround).extinction;
    }
    return glm::exp(-depth);
}

/// For a sun whose irradiance outside the air is 1. `around`: radiance that a place in the air sees on
/// average of what was scattered before.
glm::vec3 radianceFrom(glm::vec3 direction, glm::vec3 to_sun, glm::vec3 around) {
    const glm::vec3 eye(0, kGround + 0.05f, 0);
    const float reach = distanceTo(kTop, eye, direction);
    const float cosine = glm::dot(direction, to_sun), g = kForward;
    const float rayleigh_phase = 3 / (16 * kPi) * (1 + cosine * cosine);
    const float mie_phase = 3 / (8 * kPi) * (1 - g * g) * (1 + cosine * cosine) /
                            ((2 + g * g) * std::pow(1 + g * g - 2 * g * cosine, 1.5f));
    glm::vec3 sum(0), left(1);
    for (int i = 0; i < kSteps; ++i) {
        // Steps grow with the distance: the air is dense near the eye.
        const float from = static_cast<float>(i) / kSteps, to = static_cast<float>(i + 1) / kSteps;
        const float step = reach * (to * to - from * from);
        const glm::vec3 p = eye + reach * 0.5f * (from * from + to * to) * direction;
        const Air air = airAt(glm::length(p) - kGround);
        const glm::vec3 after = glm::exp(-step * air.extinction);
        const glm::vec3 sunlight = throughAir(p, to_sun);
        const glm::vec3 scattered = sunlight * (air.rayleigh * rayleigh_phase + air.mie * mie_phase) +
                                    around * (air.rayleigh + air.mie);
        sum += left * scattered * (1.0f - after) / glm::max(air.extinction, glm::vec3(1e-9f));
        left *= after;
    }
    return sum;
}

RadiancePicture upperHalf(int height, glm::vec3 to_sun, glm::vec3 around) {
    RadiancePicture picture(2 * height, height);
    for (int y = 0; y < height / 2; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.at(x, y) = radianceFrom(picture.direction(x, y), to_sun, around);
    return picture;
}

struct SkyLight {
    glm::vec3 mean{0};        ///< over the upper half
    glm::vec3 irradiance{0};  ///< on level ground
};

SkyLight lightOf(const RadiancePicture& picture) {
    SkyLight light;
    for (int y = 0; y < picture.height / 2; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 share = picture.solidAngle(y) * picture.at(x, y);
            light.mean += share / (2 * kPi);
            light.irradiance += share * picture.direction(x, y).y;
        }
    return light;
}

void scale(ClearSky& sky, float factor) {
    for (glm::vec3& texel : sky.picture.texels) texel *= factor;
    sky.sun.colour *= factor;
}

}  // namespace

ClearSky clearSky(glm::vec3 to_sun) {
    const glm::vec3 sunlight = throughAir({0, kGround + 0.05f, 0}, to_sun);
    const auto groundOf = [&](const SkyLight& sky) {
        return kGroundAlbedo / kPi * (sky.irradiance + sunlight * std::max(to_sun.y, 0.0f));
    };
    glm::vec3 around(0);
    for (int bounce = 0; bounce < kBounces; ++bounce) {
        const SkyLight sky = lightOf(upperHalf(kCoarse, to_sun, around));
        around = 0.5f * (sky.mean + groundOf(sky));
    }
    ClearSky sky{upperHalf(kHeight, to_sun, around), {to_sun, sunlight / kPi}};
    const glm::vec3 veil = kVeil * sunlight / kPi * std::max(to_sun.y, 0.0f);
    for (int y = 0; y < kHeight / 2; ++y)
        for (int x = 0; x < kWidth; ++x) sky.picture.at(x, y) += veil;
    const SkyLight light = lightOf(sky.picture);
    const glm::vec3 ground = groundOf(light);
    for (int y = kHeight / 2; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) sky.picture.at(x, y) = ground;
    // A surface facing anywhere meets a quarter of the sun on average.
    scale(sky, kEvenBrightness / luminance(0.25f * sky.sun.colour + 0.5f * (light.mean + ground)));
    return sky;
}

}  // namespace demolish::engine
