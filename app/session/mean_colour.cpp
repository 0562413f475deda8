// SPDX-License-Identifier: Apache-2.0
// Numbers, pictures and colours at the vertices are multiplied, as they are where bodies are drawn.
#include "app/session/mean_colour.h"

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

/// Linear light of each byte of sRGB: pictures have up to 268 million texels.
std::array<double, 256> linearOfBytes() {
    std::array<double, 256> light{};
    for (size_t byte = 0; byte < light.size(); ++byte) {
        const double value = static_cast<double>(byte) / 255;
        light[byte] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    return light;
}

glm::dvec3 linear(const uint8_t* rgb) {
    static const std::array<double, 256> light = linearOfBytes();
    return {light[rgb[0]], light[rgb[1]], light[rgb[2]]};
}

glm::dvec3 meanOf(const LookImage& image) {
    glm::dvec3 sum(0);
    for (size_t i = 0; i < image.texels.size(); i += 4) sum += linear(&image.texels[i]);
    return image.texels.empty() ? glm::dvec3(1) : sum / (0.25 * static_cast<double>(image.texels.size()));
}

std::vector<glm::dvec3> coloursOf(const ModelLooks& looks) {
    std::vector<glm::dvec3> colours;
    for (const LookMaterial& material : looks.materials) {
        const float(&base)[4] = material.base_colour;
        const uint32_t image = material.base_map.image;
        colours.emplace_back(glm::dvec3(base[0], base[1], base[2]) *
                             (image == kNoImage ? glm::dvec3(1) : meanOf(looks.images.at(image))));
    }
    return colours;
}

glm::dvec3 atVertices(const std::array<CornerAttributes, 3>& corners) {
    glm::dvec3 sum(0);
    for (const CornerAttributes& corner : corners) {
        const uint8_t rgb[3] = {static_cast<uint8_t>(corner.colour), static_cast<uint8_t>(corner.colour >> 8),
                                static_cast<uint8_t>(corner.colour >> 16)};
        sum += linear(rgb);
    }
    return sum / 3.0;
}

}  // namespace

std::optional<Float3> meanColour(const ImportedModel& model) {
    if (model.looks == nullptr || model.looks->materials.empty()) return std::nullopt;
    const std::vector<glm::dvec3> colours = coloursOf(*model.looks);
    glm::dvec3 sum(0);
    double whole = 0;
    for (size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const auto& corners = model.mesh.corners[t];
        const uint32_t material = corners[0].material;
        if (material >= colours.size() || model.looks->materials[material].says_nothing != 0) continue;
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) p[k] = toGlm(model.mesh.positions[model.mesh.triangles[t][k]]);
        const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
        sum += area * colours[material] * atVertices(corners);
        whole += area;
    }
    if (!(whole > 0)) return std::nullopt;
    sum = glm::min(sum / whole, glm::dvec3(1));
    return Float3{static_cast<float>(sum.x), static_cast<float>(sum.y), static_cast<float>(sum.z)};
}

}  // namespace demolish
