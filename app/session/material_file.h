// SPDX-License-Identifier: Apache-2.0
// The keys of a material: of a file in assets/materials, and of the [material] table of a scene that changes
// some.
#pragma once
#include <string>

#include "app/session/toml_reader.h"

namespace demolish {

/// Reads the keys that are there; the others keep their values. `prefix` is "" or "material.".
void readMaterial(TomlReader& reader, const std::string& prefix, Material& material);
/// Colours and roughness of outside and inside; `prefix` is "look.".
void readLook(TomlReader& reader, const std::string& prefix, engine::SurfaceLook& look);

}  // namespace demolish
