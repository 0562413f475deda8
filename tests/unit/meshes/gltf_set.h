// SPDX-License-Identifier: Apache-2.0
// A set of boxes as glTF, with the nodes, camera and sun that a test wants.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish::test {

/// Numbers of an animation: "SCALAR" times, "VEC3" places, "VEC4" turns.
struct GltfNumbers {
    std::string type;
    std::vector<float> values;
};

/// A file `name` in `folder`, and a box beside it: mesh 0, one unit long each way about the origin. `nodes`:
/// the text of glTF's list; `scene`: numbers of those without a parent; `more`: further members, each after
/// a comma; `numbers`: accessors 2, 3 and so on.
std::filesystem::path writeGltfSet(const std::filesystem::path& folder, const std::string& name,
                                   const std::string& nodes, const std::string& scene,
                                   const std::string& more = "",
                                   const std::vector<GltfNumbers>& numbers = {});

}  // namespace demolish::test
