// SPDX-License-Identifier: Apache-2.0
// Nodes of a file that assimp has read, by names that tell them apart.
#pragma once
#include <assimp/scene.h>

#include <filesystem>
#include <string>
#include <vector>

namespace demolish {

struct NamedNode {
    std::string name;  ///< as ModelPart::node has it
    const aiNode* node = nullptr;
};

/// All nodes, parents before their children.
std::vector<NamedNode> namedNodes(const aiNode& root);

/// Throws InputFileError with the names of those that have triangles.
const aiNode& requireNode(const aiNode& root, const std::string& name, const std::filesystem::path& file);

}  // namespace demolish
