// SPDX-License-Identifier: Apache-2.0
// Which file a person means who names a scene, a material or a model.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish {

/// Names of one kind of file that ships, assets/FOLDER/NAME.toml.
struct AssetKind {
    const char* folder;
    const char* word;
};
inline constexpr AssetKind kScenes{"scenes", "scene"}, kMaterials{"materials", "material"};

/// A path to a file of one's own, which ends in .toml, relative to `folder` (empty: where the program was
/// started); else the name of one that ships. Throws UsageError with the names for any other word.
std::filesystem::path tomlFileOf(const AssetKind& kind, const std::string& name,
                                 const std::filesystem::path& folder = {});

/// A model that the scene file `scene` names: relative to the folder of that file, else to assets. Where
/// there is neither, the first of them.
std::filesystem::path modelFileOf(const std::filesystem::path& scene, const std::string& model);

/// "a, b, c"
std::string listed(const std::vector<std::string>& names);

}  // namespace demolish
