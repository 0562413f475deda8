// SPDX-License-Identifier: Apache-2.0
// The tables [camera], [light] and [floor] of a scene.
#pragma once
#include "app/session/shot.h"
#include "app/session/toml_reader.h"

namespace demolish {

/// Throws InputFileError with file and line. Files of surroundings are looked for in `folder`.
void readPicture(TomlReader& reader, const std::filesystem::path& folder, Shot& shot);

}  // namespace demolish
