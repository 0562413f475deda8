// SPDX-License-Identifier: Apache-2.0
// Half floats: their ten bits show no steps in a smooth sky.
#include "engine/render/surroundings_textures.h"

#include <algorithm>
#include <cmath>

#include "engine/surroundings/octahedral.h"

namespace demolish::engine {
namespace {

constexpr GLuint kBackdropUnit = 8, kMirroredUnit = 9, kHorizonUnit = 10;
constexpr int kWidestBackdrop = 4096;  // px
constexpr float kLargestHalf = 65504.0f;

std::vector<glm::vec3> withinHalf(std::vector<glm::vec3> texels) {
    for (glm::vec3& texel : texels) texel = glm::min(texel, glm::vec3(kLargestHalf));
    return texels;
}

/// As an octahedral map, which a shader finds its way in without trigonometry.
gl::Texture backdropOf(RadiancePicture picture) {
    while (picture.width > kWidestBackdrop) picture = halved(picture);
    const int side = picture.height + 2;
    std::vector<glm::vec3> texels;
    texels.reserve(static_cast<size_t>(side) * static_cast<size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) texels.push_back(picture.sample(octahedralTexel(x, y, side)));
    gl::Texture texture = gl::Texture::make2d(GL_RGBA16F, side, side);
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    glTextureSubImage2D(texture.id(), 0, 0, 0, side, side, GL_RGB, GL_FLOAT,
                        withinHalf(std::move(texels)).data());
    return texture;
}

/// Of a layer, between the texels.
glm::vec3 mirroredRadiance(const MirroredLayers& mirrored, int layer, glm::vec3 direction) {
    const glm::vec2 at = octahedralPlace(direction, mirrored.side);
    const glm::ivec2 first(at);
    const auto texel = [&](int dx, int dy) {
        const int row = layer * mirrored.side + std::min(first.y + dy, mirrored.side - 1);
        return mirrored.texels[static_cast<size_t>(row) * static_cast<size_t>(mirrored.side) +
                               static_cast<size_t>(std::min(first.x + dx, mirrored.side - 1))];
    };
    const glm::vec2 f = at - glm::vec2(first);
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

/// Evenly by u = (1 - x) / 4 where z >= 0 and (3 + x) / 4 where z < 0, of directions with |x| + |z| = 1. A
/// little above the level, as the blur would take in the picture's ground.
gl::Texture horizonOf(const MirroredLayers& mirrored) {
    constexpr int kTexels = 64, kBlurred = 1;  // the layer
    constexpr float kAbove = 0.06f;
    std::vector<glm::vec3> horizon;
    for (int i = 0; i < kTexels; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / kTexels;
        const float x = u < 0.5f ? 1 - 4 * u : 4 * u - 3, z = 1 - std::abs(x);
        horizon.push_back(mirroredRadiance(mirrored, kBlurred, glm::vec3(x, kAbove, u < 0.5f ? z : -z)));
    }
    gl::Texture texture = gl::Texture::make2d(GL_RGBA16F, kTexels, 1);
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    texture.setWrap(GL_REPEAT);
    glTextureSubImage2D(texture.id(), 0, 0, 0, kTexels, 1, GL_RGB, GL_FLOAT, withinHalf(horizon).data());
    return texture;
}

gl::Texture mirroredOf(const MirroredLayers& layers) {
    gl::Texture texture = gl::Texture::make3d(GL_RGBA16F, layers.side, layers.side, layers.layers);
    texture.setWrap(GL_CLAMP_TO_EDGE);
    glTextureSubImage3D(texture.id(), 0, 0, 0, 0, layers.side, layers.side, layers.layers, GL_RGB, GL_FLOAT,
                        withinHalf(layers.texels).data());
    return texture;
}

}  // namespace

void SurroundingsTextures::show(const std::shared_ptr<const Surroundings>& surroundings) {
    if (shown_ == surroundings) return;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    backdrop_ = backdropOf(surroundings->backdrop);
    mirrored_ = mirroredOf(surroundings->mirrored);
    horizon_ = horizonOf(surroundings->mirrored);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    shown_ = surroundings;
}

void SurroundingsTextures::bind() const {
    backdrop_.bind(kBackdropUnit);
    mirrored_.bind(kMirroredUnit);
    horizon_.bind(kHorizonUnit);
}

}  // namespace demolish::engine
