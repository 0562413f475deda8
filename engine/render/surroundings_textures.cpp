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

/// Evenly by u = (1 - x) / 4 where z >= 0 and (3 + x) / 4 where z < 0, of directions with |x| + |z| = 1. Just
/// above the level: the lowest sky is the haze that far things fade into, and the picture's ground is not.
gl::Texture horizonOf(RadiancePicture picture) {
    constexpr int kTexels = 64, kWidest = 256;  // coarser than that, a texel would take in the ground
    while (picture.width > kWidest) picture = halved(picture);
    std::vector<glm::vec3> horizon;
    for (int i = 0; i < kTexels; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / kTexels;
        const float x = u < 0.5f ? 1 - 4 * u : 4 * u - 3, z = (u < 0.5f ? 1 : -1) * (1 - std::abs(x));
        const glm::vec3 level = glm::normalize(glm::vec3(x, 0, z));
        glm::vec3 sum(0);
        for (const float up : {0.015f, 0.03f, 0.045f}) sum += picture.sample(level + glm::vec3(0, up, 0));
        horizon.push_back(sum / 3.0f);
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
    horizon_ = horizonOf(surroundings->backdrop);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    shown_ = surroundings;
}

void SurroundingsTextures::bind() const {
    backdrop_.bind(kBackdropUnit);
    mirrored_.bind(kMirroredUnit);
    horizon_.bind(kHorizonUnit);
}

}  // namespace demolish::engine
