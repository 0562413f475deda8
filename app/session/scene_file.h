// SPDX-License-Identifier: Apache-2.0
// Scenes and materials as people write them: assets/scenes/*.toml, assets/materials/*.toml.
#pragma once
#include <string>

#include "app/session/shot.h"

namespace demolish {

inline constexpr uint32_t kSceneFileVersion = 1;

/// Throws UsageError that lists the scenes when there is none of this name; InputFileError with file and line
/// otherwise.
Shot loadScene(const std::string& name);
/// The same for one file, for tests and for scenes elsewhere.
Shot loadSceneFile(const std::filesystem::path& file);

/// Puts a material preset (and its look, where the file has one) into the shot. Throws as loadScene.
void applyMaterial(Shot& shot, const std::string& name);

}  // namespace demolish
