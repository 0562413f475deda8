// SPDX-License-Identifier: Apache-2.0
// Turned bodies: rings of vertices around the y axis between two poles.
#pragma once
#include "assets/models/recipe.h"
#include "assets/models/surface.h"

namespace demolish::sculptor {

/// A turned surface and where its parts are on a texture.
struct Turned {
    Surface surface;
    std::vector<std::array<std::array<double, 2>, 3>>
        uvs;  ///< of each triangle's corners; u around, v along the profile
};

/// Exactly `triangles` of them. The recipe's own count is 2 * sectors * rings; finer ones come from dividing
/// every interval between rings (and the sectors) m times: 2 * n * (m (rings + 1) - 1) with n even and near m
/// * sectors. Throws std::runtime_error that names the nearest counts when no such division gives the number.
Turned turnVessel(const VesselRecipe& recipe, std::size_t triangles);

/// 2 * sectors * rings triangles, plus 2 for each triangle of the bottom cap that is cut into three (one per
/// sector at most); or a finer column of the same outlines, with round flutes and mouldings: a multiple of
/// 4 * sectors triangles. Throws std::runtime_error when `triangles` is not of either kind.
Turned turnColumn(const ColumnRecipe& recipe, std::size_t triangles);
/// True for counts that only a finer column can have.
bool isDivided(const ColumnRecipe& recipe, std::size_t triangles);

}  // namespace demolish::sculptor
