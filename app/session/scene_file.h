// SPDX-License-Identifier: Apache-2.0
// Scenes and materials as people write them: those of assets/scenes and assets/materials, and files anywhere.
#pragma once
#include <filesystem>
#include <string>

#include "app/session/shot.h"

namespace demolish {

/// Of a scene that ships, or of any file whose name ends in .toml. Throws UsageError that lists the scenes
/// when there is none of this name; InputFileError with file, line and key otherwise.
Shot loadScene(const std::string& name);
/// Files that the scene names are looked for beside it, models then in assets.
Shot loadSceneFile(const std::filesystem::path& file);
/// The same of a text that is in no file, as if it were that of `place`.
Shot loadSceneText(const std::string& text, const std::filesystem::path& place);

/// A preset, or a file whose name ends in .toml. Throws as loadScene.
OwnMaterial presetMaterial(const std::string& name);
/// Puts a material (and its look, where the file has one) into the shot: a preset, or a file whose name ends
/// in .toml. Throws as loadScene.
void applyMaterial(Shot& shot, const std::string& name);
/// The same, with breaks that show the inside of `inner`; "": its own.
void applyMaterials(Shot& shot, const std::string& name, const std::string& inner);

}  // namespace demolish
