// SPDX-License-Identifier: Apache-2.0
// A set of boxes as glTF, with the nodes, camera and sun that a test wants.
#pragma once
#include <filesystem>
#include <string>

namespace demolish::test {

/// A file `name` in `folder`, and a box beside it: mesh 0, one unit long each way about the origin. `nodes`:
/// the text of glTF's list; `scene`: numbers of those without a parent; `more`: further members, each after
/// a comma.
std::filesystem::path writeGltfSet(const std::filesystem::path& folder, const std::string& name,
                                   const std::string& nodes, const std::string& scene,
                                   const std::string& more = "");

}  // namespace demolish::test
