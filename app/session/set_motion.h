// SPDX-License-Identifier: Apache-2.0
// Things of a set that its animations move, as keys of a body.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

namespace demolish {

/// Of a body, in the scene.
struct BodyPose {
    double time = 0;   ///< s
    glm::dvec3 place;  ///< m, of the point that position_m names
    glm::dquat turn;   ///< from how its file has it
};

/// rotation_deg, and, where it moves, breaks and path, each after a comma. `poses`: by ascending time from
/// 0 s, at least one.
std::string motionText(const std::vector<BodyPose>& poses);

}  // namespace demolish
