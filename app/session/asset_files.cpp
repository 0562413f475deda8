// SPDX-License-Identifier: Apache-2.0
// Names that ship, and paths.
#include "app/session/asset_files.h"

#include <algorithm>

#include "app/session/data_folder.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

fs::path tomlFileOf(const AssetKind& kind, const std::string& name, const fs::path& folder) {
    const fs::path path(name);
    if (path.extension() == ".toml") return folder / path;
    const auto names = assetNames(kind.folder);
    if (std::find(names.begin(), names.end(), name) == names.end())
        throw UsageError("there is no " + std::string(kind.word) + " '" + name +
                         "'; choose one of: " + listed(names) + "; or a file that ends in .toml" +
                         (path.has_extension() ? ", and a model by --model" : ""));
    return dataFolder() / "assets" / kind.folder / (name + ".toml");
}

fs::path modelFileOf(const fs::path& scene, const std::string& model) {
    const fs::path beside = scene.parent_path() / model, shipped = dataFolder() / "assets" / model;
    std::error_code ignored;
    return !fs::exists(beside, ignored) && fs::exists(shipped, ignored) ? shipped : beside;
}

}  // namespace demolish
