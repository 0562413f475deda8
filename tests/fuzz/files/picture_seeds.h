// SPDX-License-Identifier: Apache-2.0
// Whole pictures of surroundings, to be damaged.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish::fuzz {

/// Radiance: plain and run-length coded.
std::vector<std::string> hdrSeeds();
/// OpenEXR: one of each compression, scan lines and tiles. `folder`: for what is made on the way.
std::vector<std::string> exrSeeds(const std::filesystem::path& folder);

}  // namespace demolish::fuzz
