// SPDX-License-Identifier: Apache-2.0
// Boxes and spheres of a scene file, whatever they are for: colliders, anchors.
#pragma once
#include <string>

#include "app/session/toml_reader.h"
#include "sim_cuda/api/params.h"

namespace demolish {

/// Complains when the key is missing.
void requireKey(TomlReader& reader, const std::string& path);

/// Of the table that `at` names ("collider[0]."), m.
Box readBox(TomlReader& reader, const std::string& at);
Sphere readSphere(TomlReader& reader, const std::string& at);
/// rotation_deg: about x, then y, then z.
Quaternion readTurn(TomlReader& reader, const std::string& at);

Double3 scaled(const Double3& lengths, double by);
Box scaled(const Box& box, double by);
Sphere scaled(const Sphere& ball, double by);

}  // namespace demolish
