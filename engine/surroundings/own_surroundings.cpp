// SPDX-License-Identifier: Apache-2.0
// Painted texel by texel.
#include "engine/surroundings/own_surroundings.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/surroundings/read_picture.h"
#include "engine/surroundings/sky.h"

namespace demolish::engine {
namespace {

constexpr int kWidth = 256, kHeight = 128;
constexpr float kStudioTangent = 0.11f, kCloudTangent = 0.2f;

RadiancePicture painted(const std::function<glm::vec3(glm::vec3)>& radiance) {
    RadiancePicture picture(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) picture.at(x, y) = radiance(picture.direction(x, y));
    return picture;
}

float smoothstep(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// A lamp with a rectangular front, 1 in the middle, fading over its rim. `half`: tangents of half its width
/// and height.
float softBox(glm::vec3 direction, glm::vec3 middle, glm::vec2 half) {
    const float along = glm::dot(direction, middle);
    if (along <= 0) return 0;
    const glm::vec3 other = std::abs(middle.y) < 0.95f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(other, middle)), up = glm::cross(middle, right);
    const glm::vec2 place = glm::abs(glm::vec2(glm::dot(direction, right), glm::dot(direction, up))) / along;
    return (1 - smoothstep(0.75f, 1.1f, place.x / half.x)) * (1 - smoothstep(0.75f, 1.1f, place.y / half.y));
}

/// The same height, turned about the vertical.
glm::vec3 turnedBy(glm::vec3 direction, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    return {c * direction.x + s * direction.z, direction.y, c * direction.z - s * direction.x};
}

glm::vec3 lifted(glm::vec3 direction, float height) {
    const glm::vec2 level(direction.x, direction.z);
    const float length = glm::length(level);
    const glm::vec2 way = length > 1e-4f ? level / length : glm::vec2(1, 0);
    const float rest = std::sqrt(1 - height * height);
    return {way.x * rest, height, way.y * rest};
}

/// Mean radiance over all directions, for evening out.
float meanLuminance(const RadiancePicture& picture) {
    float sum = 0, weights = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            sum += picture.solidAngle(y) * luminance(picture.at(x, y));
            weights += picture.solidAngle(y);
        }
    return sum / weights;
}

std::shared_ptr<const Surroundings> evened(RadiancePicture picture, Sun sun) {
    const float factor = kEvenBrightness / (0.25f * luminance(sun.colour) + meanLuminance(picture));
    for (glm::vec3& texel : picture.texels) texel *= factor;
    sun.colour *= factor;
    return makeSurroundings(std::move(picture), sun);
}

std::shared_ptr<const Surroundings> studio(glm::vec3 to_lamp) {
    const glm::vec3 fill = lifted(turnedBy(to_lamp, 1.9f), 0.35f);
    const glm::vec3 strip = lifted(turnedBy(to_lamp, 3.6f), 0.45f), ceiling(0, 1, 0);
    const glm::vec3 warm(1.0f, 0.96f, 0.90f), cool(0.86f, 0.94f, 1.0f);
    RadiancePicture picture = painted([&](glm::vec3 d) {
        const glm::vec3 wall = glm::mix(glm::vec3(0.16f, 0.165f, 0.175f), glm::vec3(0.30f, 0.30f, 0.31f),
                                        smoothstep(-0.4f, 0.9f, d.y));
        return wall + 1.5f * softBox(d, fill, {0.75f, 0.6f}) * cool +
               3.2f * softBox(d, strip, {0.16f, 0.9f}) * cool +
               0.9f * softBox(d, ceiling, {0.7f, 0.7f}) * warm;
    });
    return evened(std::move(picture), {to_lamp, 2.6f * warm, kStudioTangent});
}

std::shared_ptr<const Surroundings> overcast(glm::vec3 to_sun) {
    const glm::vec3 towards = glm::normalize(glm::vec3(to_sun.x, std::max(to_sun.y, 0.0f) + 1.2f, to_sun.z));
    RadiancePicture picture = painted([&](glm::vec3 d) {
        const float overhead = (1 + 2 * std::max(d.y, 0.0f)) / 3;  // of the CIE's overcast sky
        const float brighter = 1 + 0.5f * smoothstep(0.2f, 1.0f, glm::dot(d, towards));
        const glm::vec3 cloud = overhead * brighter * glm::vec3(0.93f, 0.97f, 1.03f);
        return glm::mix(glm::vec3(0.16f), cloud, smoothstep(-0.02f, 0.02f, d.y));
    });
    return evened(std::move(picture), {towards, glm::vec3(0.75f, 0.75f, 0.74f), kCloudTangent});
}

std::shared_ptr<const Surroundings> ofFile(const SurroundingsChoice& choice) {
    RadiancePicture picture = turned(readRadiancePicture(choice.file), choice.turn);
    const std::optional<Sun> sun = takeSun(picture);
    return makeSurroundings(std::move(picture), sun);
}

}  // namespace

std::shared_ptr<const Surroundings> makeSurroundings(const SurroundingsChoice& choice) {
    switch (choice.kind) {
        case SurroundingsKind::kStudio:
            return studio(choice.to_sun);
        case SurroundingsKind::kOvercast:
            return overcast(choice.to_sun);
        case SurroundingsKind::kFile:
            return ofFile(choice);
        case SurroundingsKind::kSky:
            break;
    }
    ClearSky sky = clearSky(choice.to_sun);
    return makeSurroundings(std::move(sky.picture), sky.sun);
}

const std::shared_ptr<const Surroundings>& usualSurroundings() {
    static const std::shared_ptr<const Surroundings> sky =
        makeSurroundings({.to_sun = glm::normalize(glm::vec3(-0.52f, 0.74f, 0.50f))});
    return sky;
}

}  // namespace demolish::engine
