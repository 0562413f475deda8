// SPDX-License-Identifier: Apache-2.0
// Camera moves and matrices. Depth is reversed (near 1, far 0) in a zero-to-one clip range: float depth is
// then fine everywhere.
#include "engine/scene/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace demolish::engine {
namespace {

constexpr float kSteepest =
    1.55f;  // rad; short of the pole, where the view direction would be parallel to "up"
constexpr float kNearestDistance = 1e-3f;                // m
constexpr float kLeastAngle = 1e-3f, kMostAngle = 3.1f;  // rad, of a field of view; its tangent is finite
constexpr float kLeastAspect = 1e-4f;
constexpr float kParallel = 1e-4f;  // sine between two directions that count as one

/// A field of view that can be drawn.
float drawnAngle(float field_of_view) {
    return std::clamp(field_of_view, kLeastAngle, kMostAngle);
}

}  // namespace

glm::vec3 Camera::direction() const {
    const glm::vec3 offset = target - eye;
    const float length = glm::length(offset);
    return length > 1e-12f ? offset / length : glm::vec3(0, 0, -1);
}

glm::mat4 Camera::view() const {
    const glm::vec3 forward = direction();
    const float steep = glm::length(glm::cross(forward, up));
    const bool along_up = !(steep >= kParallel * glm::length(up)) || !(steep > 0);
    return glm::lookAt(eye, eye + forward, along_up ? glm::vec3(0, 0, -1) : up);
}

glm::mat4 Camera::projection(float aspect) const {
    const float f = 1.0f / halfHeight(aspect);
    const float range = far_plane - near_plane;
    glm::mat4 m(0.0f);
    m[0][0] = f / std::max(aspect, kLeastAspect);
    m[1][1] = f;
    m[2][2] = near_plane / range;
    m[2][3] = -1.0f;
    m[3][2] = near_plane * far_plane / range;
    return m;
}

float Camera::halfHeight(float aspect) const {
    return std::tan(0.5f * drawnAngle(field_of_view)) / std::clamp(aspect, kLeastAspect, 1.0f);
}

void Camera::orbit(float yaw, float pitch) {
    const glm::vec3 offset = eye - target;
    const float distance = std::max(glm::length(offset), kNearestDistance);
    const float new_yaw = std::atan2(offset.x, offset.z) + yaw;
    const float old_pitch = std::asin(std::clamp(offset.y / distance, -1.0f, 1.0f));
    const float new_pitch = std::clamp(old_pitch + pitch, -kSteepest, kSteepest);
    eye = target + distance * glm::vec3(std::cos(new_pitch) * std::sin(new_yaw), std::sin(new_pitch),
                                        std::cos(new_pitch) * std::cos(new_yaw));
    up = {up.x * std::cos(yaw) + up.z * std::sin(yaw), up.y, up.z * std::cos(yaw) - up.x * std::sin(yaw)};
}

void Camera::pan(float to_right, float upwards) {
    const glm::mat4 v = view();
    const glm::vec3 right_axis(v[0][0], v[1][0], v[2][0]);
    const glm::vec3 up_axis(v[0][1], v[1][1], v[2][1]);
    const float side = 2.0f * glm::length(target - eye) * std::tan(0.5f * drawnAngle(field_of_view));
    const glm::vec3 move = side * (to_right * right_axis + upwards * up_axis);
    eye += move;
    target += move;
}

void Camera::dolly(float factor) {
    const glm::vec3 offset = eye - target;
    const float distance = glm::length(offset);
    if (factor <= 0.0f || distance <= 0.0f) return;
    const float wanted =
        std::clamp(distance * factor, std::max(2.0f * near_plane, kNearestDistance), 0.5f * far_plane);
    eye = target + offset * (wanted / distance);
}

void Camera::frame(glm::vec3 centre, float radius) {
    const glm::vec3 away = -direction();
    target = centre;
    eye = centre + away * (std::max(radius, kNearestDistance) / std::sin(0.5f * drawnAngle(field_of_view)));
}

Ray pixelRay(const Camera& camera, int width, int height, float x, float y) {
    const glm::mat4 v = camera.view();
    const auto across = static_cast<float>(std::max(width, 1)),
               down = static_cast<float>(std::max(height, 1));
    const float aspect = across / down;
    const float half = camera.halfHeight(aspect);
    const float ndc_x = 2.0f * (x + 0.5f) / across - 1.0f;
    const float ndc_y = 1.0f - 2.0f * (y + 0.5f) / down;
    const glm::vec3 in_view(ndc_x * half * aspect, ndc_y * half, -1.0f);
    return {camera.eye, glm::normalize(glm::transpose(glm::mat3(v)) * in_view)};
}

}  // namespace demolish::engine
