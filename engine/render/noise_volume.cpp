// SPDX-License-Identifier: Apache-2.0
// A table instead of arithmetic per pixel: cheaper on every driver, and mip maps take the noise out where it
// would shimmer.
#include "engine/render/noise_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace demolish::engine {
namespace {

constexpr int kPeriod = 8, kTexels = 64, kLevels = 7;

glm::vec3 latticeDirection(glm::ivec3 cell) {
    const auto wrap = [](int v) { return static_cast<uint32_t>((v % kPeriod + kPeriod) % kPeriod); };
    uint32_t h = wrap(cell.x) + kPeriod * (wrap(cell.y) + kPeriod * wrap(cell.z));
    h = (h ^ 61u ^ (h >> 16)) * 0x9e3779b1u;
    h = (h ^ (h >> 15)) * 0x85ebca77u;
    h ^= h >> 13;
    const float z = static_cast<float>(h & 0xffffu) / 32767.5f - 1.0f;
    const float angle = static_cast<float>(h >> 16) * (6.2831853f / 65536.0f);
    const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Gradient noise (Perlin 2002) and its derivative: xyz gradient, w value.
glm::vec4 noiseAt(glm::vec3 p) {
    const glm::ivec3 base(glm::floor(p));
    const glm::vec3 f = p - glm::vec3(base);
    const glm::vec3 fade = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    const glm::vec3 slope = 30.0f * f * f * (f * (f - 2.0f) + 1.0f);
    glm::vec4 sum(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::vec3 direction = latticeDirection(base + offset);
        const float ramp = glm::dot(direction, f - glm::vec3(offset));
        glm::vec3 weight, derivative;
        for (int axis = 0; axis < 3; ++axis) {
            weight[axis] = offset[axis] != 0 ? fade[axis] : 1.0f - fade[axis];
            derivative[axis] = offset[axis] != 0 ? slope[axis] : -slope[axis];
        }
        const float w = weight.x * weight.y * weight.z;
        const glm::vec3 dw(derivative.x * weight.y * weight.z, weight.x * derivative.y * weight.z,
                           weight.x * weight.y * derivative.z);
        sum += glm::vec4(w * direction + dw * ramp, w * ramp);
    }
    return sum;
}

uint8_t encode(float v) {
    return static_cast<uint8_t>(std::lround(std::clamp(v * 0.5f + 0.5f, 0.0f, 1.0f) * 255.0f));
}

}  // namespace

gl::Texture makeNoiseVolume() {
    std::vector<uint8_t> texels;
    texels.reserve(size_t{4} * kTexels * kTexels * kTexels);
    const float step = static_cast<float>(kPeriod) / kTexels;
    for (int z = 0; z < kTexels; ++z) {
        for (int y = 0; y < kTexels; ++y) {
            for (int x = 0; x < kTexels; ++x) {
                const glm::vec4 n = noiseAt((glm::vec3(x, y, z) + 0.5f) * step);
                // The shader doubles gradients; values reach about 0.8, so they are stretched to use the
                // range.
                const std::array<uint8_t, 4> texel{encode(n.x * 0.5f), encode(n.y * 0.5f), encode(n.z * 0.5f),
                                                   encode(n.w * 1.25f)};
                texels.insert(texels.end(), texel.begin(), texel.end());
            }
        }
    }
    gl::Texture texture = gl::Texture::make3d(GL_RGBA8, kTexels, kTexels, kTexels, kLevels);
    glTextureSubImage3D(texture.id(), 0, 0, 0, 0, kTexels, kTexels, kTexels, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
    glGenerateTextureMipmap(texture.id());
    return texture;
}

}  // namespace demolish::engine
