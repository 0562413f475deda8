// SPDX-License-Identifier: Apache-2.0
// A table instead of a search among neighbours per pixel. Distances are stored, not coverage: their edges
// stay sharp when a texel spans many pixels.
#include "engine/render/cell_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace demolish::engine {
namespace {

constexpr int kPeriod = 8, kTexels = 64, kLevels = 7;

uint32_t hashOf(glm::ivec3 cell, uint32_t salt) {
    const auto wrap = [](int v) { return static_cast<uint32_t>((v % kPeriod + kPeriod) % kPeriod); };
    uint32_t h = wrap(cell.x) + kPeriod * (wrap(cell.y) + kPeriod * wrap(cell.z)) + salt * 0x9e3779b1u;
    h = (h ^ 61u ^ (h >> 16)) * 0x9e3779b1u;
    h = (h ^ (h >> 15)) * 0x85ebca77u;
    return h ^ (h >> 13);
}

/// Four numbers of a lattice cell, 0..1.
glm::vec4 draws(glm::ivec3 cell, uint32_t salt) {
    const uint32_t a = hashOf(cell, salt), b = hashOf(cell, salt + 1);
    return glm::vec4(a & 0xffffu, a >> 16, b & 0xffffu, b >> 16) / 65535.0f;
}

/// A stone of its own size, drawn out along an axis of its own.
struct Pebble {
    glm::vec3 centre, axis;
    float radius, flat, tone;
};

Pebble pebbleOf(glm::ivec3 cell) {
    const glm::vec4 place = draws(cell, 11), shape = draws(cell, 23);
    Pebble pebble;
    pebble.centre = glm::vec3(cell) + 0.25f + 0.5f * glm::vec3(place);
    const float turn = 6.2831853f * shape.x, height = 2 * shape.y - 1;
    const float flat = std::sqrt(std::max(0.0f, 1 - height * height));
    pebble.axis = {flat * std::cos(turn), height, flat * std::sin(turn)};
    pebble.radius = 0.16f + 0.36f * place.w * place.w;  // few large ones among small ones
    pebble.flat = 0.25f + 0.55f * shape.z;              // how much thinner along the axis
    pebble.tone = shape.w;
    return pebble;
}

/// Lattice cells beyond its edge, negative inside.
float outsideOf(const Pebble& pebble, glm::vec3 p) {
    const glm::vec3 away = p - pebble.centre;
    const float along = glm::dot(away, pebble.axis);
    return glm::length(away + pebble.flat * along * pebble.axis) - pebble.radius;
}

struct Nearest {
    float pebble = 1e9f, pebble_tone = 0;
    float first = 1e9f, second = 1e9f, crystal_tone = 0;  ///< squared distances
};

void look(glm::ivec3 cell, glm::vec3 p, Nearest& found) {
    const Pebble pebble = pebbleOf(cell);
    const float beyond = outsideOf(pebble, p);
    if (beyond < found.pebble) {
        found.pebble = beyond;
        found.pebble_tone = pebble.tone;
    }
    const glm::vec4 crystal = draws(cell, 37);
    const glm::vec3 away = p - glm::vec3(cell) - glm::vec3(crystal);
    const float distance = glm::dot(away, away);
    if (distance < found.first) {
        found.second = found.first;
        found.first = distance;
        found.crystal_tone = crystal.w;
    } else {
        found.second = std::min(found.second, distance);
    }
}

uint8_t encode(float v) {
    return static_cast<uint8_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f));
}

std::array<uint8_t, 4> texelAt(glm::vec3 p) {
    const glm::ivec3 base(glm::floor(p));
    Nearest found;
    for (int k = 0; k < 27; ++k) look(base + glm::ivec3(k % 3, k / 3 % 3, k / 9) - 1, p, found);
    const float border = std::sqrt(found.second) - std::sqrt(found.first);
    return {encode(0.5f + found.pebble), encode(found.pebble_tone), encode(border),
            encode(found.crystal_tone)};
}

}  // namespace

gl::Texture makeCellVolume() {
    std::vector<uint8_t> texels;
    texels.reserve(size_t{4} * kTexels * kTexels * kTexels);
    const float step = static_cast<float>(kPeriod) / kTexels;
    for (int z = 0; z < kTexels; ++z)
        for (int y = 0; y < kTexels; ++y)
            for (int x = 0; x < kTexels; ++x) {
                const auto texel = texelAt((glm::vec3(x, y, z) + 0.5f) * step);
                texels.insert(texels.end(), texel.begin(), texel.end());
            }
    gl::Texture texture = gl::Texture::make3d(GL_RGBA8, kTexels, kTexels, kTexels, kLevels);
    glTextureSubImage3D(texture.id(), 0, 0, 0, 0, kTexels, kTexels, kTexels, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
    glGenerateTextureMipmap(texture.id());
    return texture;
}

}  // namespace demolish::engine
