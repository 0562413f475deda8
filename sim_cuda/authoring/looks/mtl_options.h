// SPDX-License-Identifier: Apache-2.0
// Options of the pictures that an OBJ's material files name (map_Kd -s 4 4 1 wood.png): assimp passes them
// over.
#pragma once
#include <assimp/material.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim_cuda/authoring/looks/uv_transform.h"

namespace demolish {

struct MtlPicture {
    std::string name;
    UvTransform laid;                     ///< by -s and -o
    float bump = 1;                       ///< -bm
    std::vector<std::string> unfollowed;  ///< the other options that change what is seen
};

class MtlOptions {
  public:
    /// Of what `model` names, if it is an OBJ; material files that cannot be read have none.
    explicit MtlOptions(const std::filesystem::path& model);

    /// Null where the material's picture has no options.
    const MtlPicture* find(const std::string& material, aiTextureType type) const;
    bool names(const std::string& material) const;

  private:
    void readMaterials(const std::filesystem::path& file);

    std::map<std::pair<std::string, aiTextureType>, MtlPicture> pictures_;
};

/// The rest of a line after its keyword.
MtlPicture mtlPictureOf(const std::string& text);

}  // namespace demolish
