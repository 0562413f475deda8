// SPDX-License-Identifier: Apache-2.0
// Materials of a model file, whatever its format calls their numbers.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include "sim_cuda/api/model_looks.h"
#include "sim_cuda/authoring/looks/uv_transform.h"

struct aiScene;

namespace demolish {

struct ImportedLooks {
    /// Numbered as the scene's. Null where neither materials nor corners say more than that there is a
    /// surface.
    std::shared_ptr<const ModelLooks> looks;
    /// By material, for both sets of UVs: what has to be done to the file's.
    std::vector<std::array<UvTransform, 2>> uv_transforms;
};

ImportedLooks importLooks(const std::filesystem::path& model, const aiScene& scene);

}  // namespace demolish
