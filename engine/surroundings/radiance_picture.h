// SPDX-License-Identifier: Apache-2.0
// What comes from all directions, as a picture: longitude across, latitude down.
#pragma once
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace demolish::engine {

/// Linear light, sRGB primaries, rows from the zenith down. The middle column looks along -z, columns to the
/// right of it turn to +x.
struct RadiancePicture {
    int width = 0, height = 0;  ///< px
    std::vector<glm::vec3> texels;

    RadiancePicture() = default;
    RadiancePicture(int width_px, int height_px, glm::vec3 radiance = glm::vec3(0))
        : width(width_px),
          height(height_px),
          texels(static_cast<size_t>(width_px) * static_cast<size_t>(height_px), radiance) {}

    glm::vec3& at(int x, int y) { return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + x]; }
    const glm::vec3& at(int x, int y) const {
        return texels[static_cast<size_t>(y) * static_cast<size_t>(width) + x];
    }
    glm::vec3 direction(int x, int y) const;  ///< unit, through the middle of a texel
    float solidAngle(int y) const;            ///< sr, of each texel of a row
    /// Radiance from a unit direction, between the four nearest texels.
    glm::vec3 sample(glm::vec3 direction) const;
};

/// Half as wide and high (at least 1): each texel the mean of those it covers, by their solid angles.
RadiancePicture halved(const RadiancePicture& picture);
/// Turned about the vertical by whole columns: what came from -z comes from `degrees` towards +x.
RadiancePicture turned(const RadiancePicture& picture, double degrees);

/// Relative luminance of linear sRGB.
inline float luminance(glm::vec3 colour) {
    return glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

}  // namespace demolish::engine
