// SPDX-License-Identifier: Apache-2.0
// Search for the data folder from the program's own place.
#include "app/session/data_folder.h"

#include <algorithm>
#include <cstdlib>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

bool holdsData(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "assets" / "scenes", error);
}

fs::path search() {
    if (const char* chosen = std::getenv("DEMOLISH_DATA")) {
        if (holdsData(chosen)) return chosen;
        throw InputFileError(
            "DEMOLISH_DATA is '" + std::string(chosen) +
            "', which has no assets/scenes; set it to the folder that holds assets and shaders");
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        const fs::path bundle = program.parent_path().parent_path() / "share" / "demolish";
        if (holdsData(bundle)) return bundle;
        for (fs::path up = program.parent_path(); up != up.parent_path(); up = up.parent_path())
            if (holdsData(up)) return up;
    }
    if (holdsData(DEMOLISH_SOURCE_DIR)) return DEMOLISH_SOURCE_DIR;
    throw InputFileError("no assets found beside " + program.string() +
                         "; set DEMOLISH_DATA to the folder that holds them");
}

}  // namespace

fs::path dataFolder() {
    static const fs::path kFolder = search();
    return kFolder;
}

std::vector<std::string> assetNames(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(dataFolder() / "assets" / folder, error))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace demolish
