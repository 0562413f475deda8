// SPDX-License-Identifier: Apache-2.0
// Longitudes and latitudes.
#include "engine/surroundings/radiance_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demolish::engine {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace

glm::vec3 RadiancePicture::direction(int x, int y) const {
    const float longitude = 2 * kPi * ((static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 0.5f);
    const float from_zenith = kPi * (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
    const float level = std::sin(from_zenith);
    return {level * std::sin(longitude), std::cos(from_zenith), -level * std::cos(longitude)};
}

float RadiancePicture::solidAngle(int y) const {
    const float above = std::cos(kPi * static_cast<float>(y) / static_cast<float>(height));
    const float below = std::cos(kPi * static_cast<float>(y + 1) / static_cast<float>(height));
    return 2 * kPi / static_cast<float>(width) * (above - below);
}

glm::vec3 RadiancePicture::sample(glm::vec3 direction) const {
    const float u = 0.5f + std::atan2(direction.x, -direction.z) / (2 * kPi);
    const float v = std::acos(std::clamp(direction.y, -1.0f, 1.0f)) / kPi;
    const float x = u * static_cast<float>(width) - 0.5f, y = v * static_cast<float>(height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const auto texel = [&](int dx, int dy) {
        const int column = (static_cast<int>(left) + dx + width) % width;
        return at(column, std::clamp(static_cast<int>(top) + dy, 0, height - 1));
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), x - left),
                    glm::mix(texel(0, 1), texel(1, 1), x - left), y - top);
}

RadiancePicture halved(const RadiancePicture& picture) {
    RadiancePicture half(std::max(1, picture.width / 2), std::max(1, picture.height / 2));
    for (int y = 0; y < half.height; ++y) {
        const int row = std::min(2 * y + 1, picture.height - 1);
        const float upper = picture.solidAngle(2 * y), lower = picture.solidAngle(row);
        for (int x = 0; x < half.width; ++x) {
            const int column = std::min(2 * x + 1, picture.width - 1);
            const glm::vec3 above = picture.at(2 * x, 2 * y) + picture.at(column, 2 * y);
            const glm::vec3 below = picture.at(2 * x, row) + picture.at(column, row);
            half.at(x, y) = 0.5f * (upper * above + lower * below) / (upper + lower);
        }
    }
    return half;
}

RadiancePicture turned(const RadiancePicture& picture, double degrees) {
    const double share = degrees / 360 - std::floor(degrees / 360);
    const auto columns = static_cast<int>(std::lround(share * picture.width)) % picture.width;
    RadiancePicture result = picture;
    for (int y = 0; y < picture.height; ++y)
        std::rotate(&result.at(0, y), &result.at(0, y) + (picture.width - columns) % picture.width,
                    &result.at(0, y) + picture.width);
    return result;
}

}  // namespace demolish::engine
