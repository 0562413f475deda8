// SPDX-License-Identifier: Apache-2.0
// The camera of a file that assimp has read, and how it moves.
#pragma once
#include <assimp/scene.h>

#include <optional>

#include "sim_cuda/api/model_set.h"

namespace demolish {

/// The first one that has a place and an angle; none: there is no such.
std::optional<SetCamera> importCamera(const aiScene& scene, bool is_gltf);

}  // namespace demolish
