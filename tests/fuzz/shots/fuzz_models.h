// SPDX-License-Identifier: Apache-2.0
// Closed meshes of many kinds, as files: compact and thin ones, several parts, cavities, chains of small
// parts.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish::fuzz {

/// What can be broken: a scene of the program, or a model that modelFile() writes.
struct Subject {
    std::string name;
    bool is_scene = false;
    double volume = 0;  ///< m^3 of one body, scaled to a height of 1 m; of a scene at its own height
};

/// Always the same ones in the same order.
const std::vector<Subject>& subjects();
/// The OBJ file of a subject that is no scene, in `folder`; written where it is not there yet.
std::filesystem::path modelFile(const std::string& name, const std::filesystem::path& folder);

}  // namespace demolish::fuzz
