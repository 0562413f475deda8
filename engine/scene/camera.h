// SPDX-License-Identifier: Apache-2.0
// Camera: a point that looks at a target, perspective. Orbit, pan, dolly, frame.
#pragma once
#include <glm/glm.hpp>

namespace demolish::engine {

struct Camera {
    glm::vec3 eye{1.2f, 0.8f, 1.6f};  ///< m
    glm::vec3 target{0, 0.4f, 0};     ///< m
    glm::vec3 up{0, 1, 0};            ///< what points up in the picture, any length; not along the view
    float field_of_view = 0.7f;       ///< rad, across the picture's shorter side: upright ones show as much
    float near_plane = 0.01f;         ///< m
    float far_plane = 1000.0f;        ///< m; reversed float depth stays precise, so far costs nothing

    // Finite numbers for any finite place and angle: with the eye in the target it looks along -z, along
    // its up with -z upwards, and angles that cannot be drawn become the nearest that can.
    glm::vec3 direction() const;  ///< that it looks in, unit
    glm::mat4 view() const;
    glm::mat4 projection(float aspect) const;  ///< `aspect`: width over height
    float halfHeight(float aspect) const;      ///< of what the picture shows, at distance 1

    /// rad, about the vertical through the target, which takes `up` along, and up; never flips over the pole.
    void orbit(float yaw, float pitch);
    void pan(float to_right, float upwards);  ///< in units of the view's shorter side at the target
    void dolly(float factor);                 ///< distance to the target times factor, > 0
    void frame(glm::vec3 centre,
               float radius);  ///< moves along the view direction until the sphere fills the view

    bool operator==(const Camera&) const = default;
};

/// Ray through a pixel (origin top left), world space, unit direction.
struct Ray {
    glm::vec3 origin, direction;
};
Ray pixelRay(const Camera& camera, int width, int height, float x, float y);

}  // namespace demolish::engine
