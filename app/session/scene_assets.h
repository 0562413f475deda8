// SPDX-License-Identifier: Apache-2.0
// Models and materials that a scene file names.
#pragma once
#include <filesystem>
#include <string>

#include "app/session/scene_parts.h"
#include "app/session/toml_reader.h"

namespace demolish {

/// Both throw InputFileError with file, line and key where there is no such file or it is wrong.
/// A mesh beside the scene, else in assets.
std::filesystem::path readModelPath(TomlReader& reader, const std::string& key);
/// `node`, `up` and `unit` of this model under `prefix`, where they are given.
void readPart(TomlReader& reader, const std::string& prefix, const std::filesystem::path& model,
              ModelPart& part);
/// A preset, or a file beside the scene that ends in .toml: its path then, good wherever the program was
/// started.
OwnMaterial readOwnMaterial(TomlReader& reader, const std::string& key);

/// The key's material is the inside of `own`, where the key is given.
void readInside(TomlReader& reader, const std::string& key, OwnMaterial& own);

/// Breaks show the inside of another material: its colour, roughness, pattern and dust. Throws UsageError
/// where either is transparent, since glass has no inside to be told from its outside.
void showInside(const OwnMaterial& inner, OwnMaterial& own);

/// A material's file. Throws InputFileError.
OwnMaterial loadMaterial(const std::string& name, const std::filesystem::path& file);

}  // namespace demolish
