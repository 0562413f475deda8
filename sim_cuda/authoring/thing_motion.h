// SPDX-License-Identifier: Apache-2.0
// How animations move a thing of a set.
#pragma once
#include <assimp/scene.h>

#include <vector>

#include "sim_cuda/api/model_set.h"

namespace demolish {

/// SetThing::motion of the node, whose box `thing` has. What changes its size or is sheared is taken without
/// that.
std::vector<SetPose> motionOf(const aiScene& scene, const aiNode& node, const SetThing& thing);

}  // namespace demolish
