// SPDX-License-Identifier: Apache-2.0
// Where assets and shaders lie, for a build run and for an installed bundle alike.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish {

/// Folder that holds assets/ and shaders/: DEMOLISH_DATA if set, else share/demolish beside the program's
/// bin, else the source tree around the program or that it was built from. Throws InputFileError with the
/// remedy.
std::filesystem::path dataFolder();

/// Names of the .toml files in a folder under assets, without ending, sorted.
std::vector<std::string> assetNames(const std::string& folder);

}  // namespace demolish
