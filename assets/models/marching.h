// SPDX-License-Identifier: Apache-2.0
// Turns a signed distance into a closed surface by marching tetrahedra.
#pragma once
#include <functional>

#include "assets/models/field.h"
#include "assets/models/surface.h"

namespace demolish::sculptor {

/// Signed distance at a point; must be safe to call from several threads.
using Distance = std::function<double(Vec3)>;

/// Zero surface of `distance` on cubes of edge `cell` that cover `box` with two cells to spare. Each cube is
/// cut into six tetrahedra along its main diagonal (Kuhn), so that neighbours agree on every face and the
/// surface is a closed manifold. Crossings keep 2 % of an edge away from its ends: no triangle is without
/// area. Vertices and triangles come in scan order, so the result does not depend on the number of threads.
/// Throws std::runtime_error when the body touches the grid's border.
Surface marchTetrahedra(const Distance& distance, const Box& box, double cell);

}  // namespace demolish::sculptor
