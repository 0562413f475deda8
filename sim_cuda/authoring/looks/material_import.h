// SPDX-License-Identifier: Apache-2.0
// Materials of a model file, whatever its format calls their numbers.
#pragma once
#include <filesystem>
#include <memory>

#include "sim_cuda/api/model_looks.h"

struct aiScene;

namespace demolish {

/// Numbered as the scene's. Null where neither materials nor corners say more than that there is a surface.
std::shared_ptr<const ModelLooks> importLooks(const std::filesystem::path& model, const aiScene& scene);

}  // namespace demolish
