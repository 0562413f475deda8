// SPDX-License-Identifier: Apache-2.0
// Pictures that a glTF file names by an extension alone, in formats that are not read: assimp passes them
// over.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish {

/// One sentence each, without full stop; none for other formats.
struct GltfLeftOut {
    std::vector<std::string> pictures, nodes;
};

GltfLeftOut gltfLeftOut(const std::filesystem::path& model);

}  // namespace demolish
