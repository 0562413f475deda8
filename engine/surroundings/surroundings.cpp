// SPDX-License-Identifier: Apache-2.0
// Harmonics after Ramamoorthi and Hanrahan (2001); mirrored layers by importance sampling of GGX (Karis 2013)
// with wider samples from smaller pictures (Krivanek and Colbert 2008).
#include "engine/surroundings/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/surroundings/octahedral.h"

namespace demolish::engine {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kLayers = 8, kSamples = 48;
/// Texels between the poles: rough layers need no more, and nothing of ours is a mirror.
constexpr int kLargestSide = 128, kLargestSource = 512;

std::array<float, 9> basis(glm::vec3 n) {
    return {1, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3 * n.z * n.z - 1, n.x * n.z, n.x * n.x - n.y * n.y};
}

/// Squares of the real harmonics' constants, times the cosine lobe's share (1, 2/3, 1/4), of each basis
/// function.
std::array<float, 9> constants() {
    const float c1 = 3 / (4 * kPi) * 2 / 3, c2 = 15 / (4 * kPi) / 4;
    return {1 / (4 * kPi), c1, c1, c1, c2, c2, c2 / 12, c2, c2 / 4};
}

Harmonics harmonicsOf(const RadiancePicture& picture, int first_row, int end_row) {
    Harmonics sum{};
    for (int y = first_row; y < end_row; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::array<float, 9> b = basis(picture.direction(x, y));
            const glm::vec3 light = picture.solidAngle(y) * picture.at(x, y);
            for (size_t k = 0; k < 9; ++k) sum[k] += b[k] * light;
        }
    const std::array<float, 9> factor = constants();
    for (size_t k = 0; k < 9; ++k) sum[k] *= factor[k];
    return sum;
}

/// The i-th of n points that fill a square evenly (Hammersley).
glm::vec2 evenPoint(uint32_t i, uint32_t n) {
    uint32_t bits = i;
    uint32_t mirror = 0;
    for (int k = 0; k < 32; ++k, bits >>= 1) mirror = mirror << 1 | (bits & 1);
    return {(static_cast<float>(i) + 0.5f) / static_cast<float>(n), static_cast<float>(mirror) * 0x1p-32f};
}

/// A direction that light comes from, about +z, its weight, and the size of picture to look it up in.
struct LobeSample {
    glm::vec3 direction;
    float weight;
    size_t level;
};

std::vector<LobeSample> lobe(float roughness, const std::vector<RadiancePicture>& levels) {
    if (roughness <= 0) return {{{0, 0, 1}, 1, 0}};
    const float a = roughness * roughness;
    const float texel = 4 * kPi / static_cast<float>(levels[0].width * levels[0].height);
    std::vector<LobeSample> samples;
    for (uint32_t i = 0; i < kSamples; ++i) {
        const glm::vec2 point = evenPoint(i, kSamples);
        const float cosine = std::sqrt((1 - point.x) / (1 + (a * a - 1) * point.x));
        const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
        const float angle = 2 * kPi * point.y;
        const glm::vec3 half_way(sine * std::cos(angle), sine * std::sin(angle), cosine);
        const glm::vec3 light = 2 * cosine * half_way - glm::vec3(0, 0, 1);
        if (light.z <= 0) continue;
        const float d = cosine * cosine * (a * a - 1) + 1;
        const float density = a * a / (kPi * d * d) / 4;  // of light, about the mirrored ray
        const float width = 1 / (kSamples * density) / texel;
        const float level = std::max(0.0f, 0.5f * std::log2(width) + 1);
        samples.push_back(
            {light, light.z, std::min(static_cast<size_t>(std::lround(level)), levels.size() - 1)});
    }
    return samples;
}

glm::vec3 gathered(const std::vector<LobeSample>& samples, glm::vec3 about,
                   const std::vector<RadiancePicture>& levels) {
    const glm::vec3 other = std::abs(about.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(other, about)), up = glm::cross(about, right);
    glm::vec3 sum(0);
    float weights = 0;
    for (const LobeSample& s : samples) {
        const glm::vec3 direction = s.direction.x * right + s.direction.y * up + s.direction.z * about;
        sum += s.weight * levels[s.level].sample(direction);
        weights += s.weight;
    }
    return sum / weights;
}

std::vector<RadiancePicture> levelsOf(const RadiancePicture& picture) {
    std::vector<RadiancePicture> levels{picture};
    while (levels[0].width > kLargestSource) levels[0] = halved(levels[0]);
    while (levels.back().height > 4) levels.push_back(halved(levels.back()));
    return levels;
}

MirroredLayers mirroredOf(const RadiancePicture& picture) {
    const std::vector<RadiancePicture> levels = levelsOf(picture);
    MirroredLayers result;
    result.side = std::clamp(levels[0].height / 2, 16, kLargestSide) + 2;
    result.layers = kLayers;
    for (int layer = 0; layer < kLayers; ++layer) {
        const float roughness = static_cast<float>(layer) / (kLayers - 1);
        const std::vector<LobeSample> samples = lobe(roughness, levels);
        for (int y = 0; y < result.side; ++y)
            for (int x = 0; x < result.side; ++x)
                result.texels.push_back(gathered(samples, octahedralTexel(x, y, result.side), levels));
    }
    return result;
}

}  // namespace

glm::vec3 evaluate(const Harmonics& harmonics, glm::vec3 normal) {
    const std::array<float, 9> b = basis(normal);
    glm::vec3 sum(0);
    for (size_t k = 0; k < 9; ++k) sum += b[k] * harmonics[k];
    return glm::max(sum, glm::vec3(0));
}

std::shared_ptr<const Surroundings> makeSurroundings(RadiancePicture picture, std::optional<Sun> sun) {
    auto made = std::make_shared<Surroundings>();
    RadiancePicture small = picture;
    while (small.width > kLargestSource) small = halved(small);
    const int horizon = small.height / 2;
    made->above = harmonicsOf(small, 0, horizon);
    made->below = harmonicsOf(small, horizon, small.height);
    made->mirrored = mirroredOf(small);
    made->backdrop = std::move(picture);
    made->sun = sun;
    return made;
}

}  // namespace demolish::engine
