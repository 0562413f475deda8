// SPDX-License-Identifier: Apache-2.0
// What placing bodies and throwing balls have in common.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/session/scene_parts.h"
#include "sim_cuda/api/breakable_body.h"

namespace demolish {

inline constexpr double kGravity = 9.81;  // m/s^2

inline glm::dvec3 toGlm(const Double3& v) {
    return {v.x, v.y, v.z};
}
inline Double3 fromGlm(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// From the frame of a body that stands in its place to the scene's.
inline glm::dquat turnOf(const SceneBody& body) {
    const Quaternion& q = body.turn;
    return glm::angleAxis(body.yaw, glm::dvec3(0, 1, 0)) * glm::dquat(q.w, q.x, q.y, q.z);
}

/// m
inline double heightOf(const BreakableBody& body) {
    return body.bounds_max.y - body.bounds_min.y;
}

}  // namespace demolish
