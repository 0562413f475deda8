// SPDX-License-Identifier: Apache-2.0
// A model file as assimp reads it.
#pragma once
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>

namespace demolish {

/// Triangles, in metres where the format says its unit; the importer owns them. Throws InputFileError: no
/// plain file, unreadable.
const aiScene& readScene(Assimp::Importer& importer, const std::filesystem::path& file);

/// Colours of vertices are linear in it, not meant for the screen.
bool isGltf(const std::filesystem::path& file);

}  // namespace demolish
