// SPDX-License-Identifier: Apache-2.0
// Nodes of model files that a scene file names: where they lie, and boxes round them.
#pragma once
#include <filesystem>
#include <string>

#include "app/session/scene_parts.h"
#include "app/session/toml_reader.h"
#include "sim_cuda/api/params.h"

namespace demolish {

/// A node of a file that keeps the file's lengths and origin.
struct PlacedNode {
    std::filesystem::path file;
    ModelPart part;
    double scale = 1;     ///< m, a length of 1 in the file
    Double3 position;     ///< m, of the file's origin
    Quaternion rotation;  ///< unit, from the file's frame, y up, to the world
};

/// The keys `model` (where it is left out, `usual`), `node`, `up`, `unit`, `scale`, `position_m` and
/// `rotation_deg` of the table that `at` names ("collider[0]."). Complains where there is no model.
PlacedNode readPlacedNode(TomlReader& reader, const std::string& at, const std::filesystem::path& usual);

/// m, the box round the triangles of the node that these keys name, along the axes of its file. Complains
/// where the key `node` is missing, and about the key of a file or node that cannot be read.
Box readNodeBox(TomlReader& reader, const std::string& at, const std::filesystem::path& usual);

/// m, the box round the node that the key `node` names of the body's own file, in the body's own frame.
/// Where a repair makes the body larger (sheets that are thickened), the box is off by half of that.
Box readOwnNodeBox(TomlReader& reader, const std::string& at, const Shot& shot, const SceneBody& body);

}  // namespace demolish
