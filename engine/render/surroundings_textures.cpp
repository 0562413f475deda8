// SPDX-License-Identifier: Apache-2.0
// Half floats: their ten bits show no steps in a smooth sky.
#include "engine/render/surroundings_textures.h"

#include <algorithm>
#include <array>
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

/// The lowest sky, which far things fade into and the picture's ground is not: evenly by u = (1 - x) / 4
/// where z >= 0 and (3 + x) / 4 where z < 0, of directions with |x| + |z| = 1.
class Horizon {
  public:
    explicit Horizon(RadiancePicture picture) {
        constexpr int kWidest = 256;  // coarser than that, a texel would take in the ground
        while (picture.width > kWidest) picture = halved(picture);
        for (size_t i = 0; i < kTexels; ++i) {
            const float u = (static_cast<float>(i) + 0.5f) / kTexels;
            const float x = u < 0.5f ? 1 - 4 * u : 4 * u - 3, z = (u < 0.5f ? 1 : -1) * (1 - std::abs(x));
            const glm::vec3 level = glm::normalize(glm::vec3(x, 0, z));
            glm::vec3 sum(0);
            for (const float up : {0.015f, 0.03f, 0.045f}) sum += picture.sample(level + glm::vec3(0, up, 0));
            texels_[i] = glm::min(sum / 3.0f, glm::vec3(kLargestHalf));
        }
    }
    gl::Texture texture() const {
        gl::Texture texture = gl::Texture::make2d(GL_RGBA16F, kTexels, 1);
        texture.setFilter(GL_LINEAR, GL_LINEAR);
        texture.setWrap(GL_REPEAT);
        glTextureSubImage2D(texture.id(), 0, 0, 0, kTexels, 1, GL_RGB, GL_FLOAT, texels_.data());
        return texture;
    }
    /// As the texture has it.
    glm::vec3 at(glm::vec3 direction) const {
        const float x = direction.x / std::max(std::abs(direction.x) + std::abs(direction.z), 1e-9f);
        const float place = kTexels * 0.25f * (direction.z >= 0 ? 1 - x : 3 + x) + kTexels - 0.5f;
        const auto first = static_cast<size_t>(place);
        return glm::mix(texels_[first % kTexels], texels_[(first + 1) % kTexels],
                        place - static_cast<float>(first));
    }

  private:
    static constexpr int kTexels = 64;
    std::array<glm::vec3, kTexels> texels_;
};

/// As an octahedral map, which a shader finds its way in without trigonometry. Over a floor, which ends in
/// the haze of the horizon, that also hides what lies behind it, or the picture's ground would show as a
/// line.
gl::Texture backdropOf(RadiancePicture picture, const Horizon* over_floor) {
    constexpr float kMist = 0.025f;  // sine of the height up to which
    while (picture.width > kWidestBackdrop) picture = halved(picture);
    const int side = picture.height + 2;
    std::vector<glm::vec3> texels;
    texels.reserve(static_cast<size_t>(side) * static_cast<size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec3 direction = octahedralTexel(x, y, side), seen = picture.sample(direction);
            const float clear = over_floor != nullptr ? glm::smoothstep(0.0f, kMist, direction.y) : 1;
            texels.push_back(clear < 1 ? glm::mix(over_floor->at(direction), seen, clear) : seen);
        }
    gl::Texture texture = gl::Texture::make2d(GL_RGBA16F, side, side);
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    glTextureSubImage2D(texture.id(), 0, 0, 0, side, side, GL_RGB, GL_FLOAT,
                        withinHalf(std::move(texels)).data());
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

void SurroundingsTextures::show(const std::shared_ptr<const Surroundings>& surroundings, bool over_floor) {
    if (shown_ == surroundings && over_floor_ == over_floor) return;
    const Horizon horizon(surroundings->backdrop);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    backdrop_ = backdropOf(surroundings->backdrop, over_floor ? &horizon : nullptr);
    if (shown_ != surroundings) mirrored_ = mirroredOf(surroundings->mirrored);
    horizon_ = horizon.texture();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    shown_ = surroundings;
    over_floor_ = over_floor;
}

void SurroundingsTextures::bind() const {
    backdrop_.bind(kBackdropUnit);
    mirrored_.bind(kMirroredUnit);
    horizon_.bind(kHorizonUnit);
}

}  // namespace demolish::engine
