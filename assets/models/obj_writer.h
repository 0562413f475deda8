// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ text with fixed decimals: the same bytes for the same surface.
#pragma once
#include <filesystem>
#include <string>

#include "assets/models/corners.h"

namespace demolish::sculptor {

/// A finished model in metres, y up, standing on y = 0.
struct Model {
    Surface surface;
    CornerNormals normals;
    CornerUvs uvs;
};

/// Positions with 6 decimals in the surface's order; normals (4 decimals) and texture coordinates (5) are
/// listed once each, in the order of first use.
std::string objText(const Model& model, const std::string& title);

/// Writes beside the file and renames, so that a reader never sees half of it. Throws std::runtime_error.
void writeText(const std::filesystem::path& file, const std::string& text);

}  // namespace demolish::sculptor
