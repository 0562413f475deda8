// SPDX-License-Identifier: Apache-2.0
// Angles of a path are interpolated one by one: each key takes those that are nearest to the key before it.
#include "app/session/set_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace demolish {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// rad, about x, then y, then z: those of the same rotation that are nearest to `near`.
glm::dvec3 anglesNear(const glm::dquat& q, const glm::dvec3& near) {
    const glm::dmat3 m = glm::mat3_cast(q);  // columns
    const double y = std::asin(std::clamp(-m[0][2], -1.0, 1.0));
    glm::dvec3 one(std::atan2(m[1][2], m[2][2]), y, std::atan2(m[0][1], m[0][0]));
    if (std::hypot(m[0][0], m[0][1]) < 1e-6) {  // x and z turn about one axis
        const double sign = y > 0 ? 1 : -1;
        one = {near.x, y, sign * (near.x - std::atan2(sign * m[1][0], m[1][1]))};
    }
    const double half = std::numbers::pi;
    glm::dvec3 best = one;
    double least = 1e300;
    for (glm::dvec3 angles : {one, glm::dvec3(one.x + half, half - one.y, one.z + half)}) {
        angles += kTurn * glm::round((near - angles) / kTurn);
        const double away = glm::length(angles - near);
        if (away < least) best = angles;
        least = std::min(least, away);
    }
    return best;
}

std::string vectorText(const glm::dvec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "[%.6g, %.6g, %.6g]", v.x + 0.0, v.y + 0.0, v.z + 0.0);
    return text;
}

}  // namespace

std::string motionText(const std::vector<BodyPose>& poses) {
    const BodyPose& start = poses.front();
    const glm::dvec3 stands = anglesNear(start.turn, glm::dvec3(0));
    std::string text = ", rotation_deg = " + vectorText(glm::degrees(stands));
    if (poses.size() == 1) return text;
    text += ", breaks = false, path = [\n";
    glm::dvec3 angles(0);
    for (size_t k = 1; k < poses.size(); ++k) {
        angles = anglesNear(poses[k].turn * glm::conjugate(start.turn), angles);
        char time[48];
        std::snprintf(time, sizeof time, "    { at_s = %.9g, position_m = ", poses[k].time);
        text += time + vectorText(poses[k].place - start.place) +
                ", rotation_deg = " + vectorText(glm::degrees(angles)) + " },\n";
    }
    return text + "  ]";
}

}  // namespace demolish
