// SPDX-License-Identifier: Apache-2.0
// Normals and texture coordinates of triangle corners.
#pragma once
#include "assets/models/surface.h"

namespace demolish::sculptor {

using CornerNormals = std::vector<std::array<Vec3, 3>>;
using CornerUvs = std::vector<std::array<std::array<double, 2>, 3>>;

/// Unit normals, triangles weighted by their angle at the vertex. A corner averages the triangles around its
/// vertex that meet its own at no more than `crease_degrees`: 180 all of them, 0 its own plane only.
CornerNormals cornerNormals(const Surface& surface, double crease_degrees);

/// Longitude and latitude around the middle of the surface's bounding box, 0..1 each; u is 0.5 towards +z,
/// its seam lies towards -z, where triangles that cross it go on beyond 1.
CornerUvs sphericalUvs(const Surface& surface);

}  // namespace demolish::sculptor
