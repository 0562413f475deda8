// SPDX-License-Identifier: Apache-2.0
// From rings of vertices to a closed surface.
#pragma once
#include <vector>

#include "assets/models/lathe.h"

namespace demolish::sculptor {

/// One ring of vertices around the y axis.
struct TurnedRing {
    double radius = 0, y = 0;  ///< on the profile
    std::vector<Vec3> points;  ///< as many as there are sectors, from +x to -z
};

/// Vertices: first pole, rings, last pole (at height `last_pole`). The first pole lies in the plane of the
/// first ring. At least one ring; all with the same number of points.
Turned revolve(const std::vector<TurnedRing>& rings, double last_pole);

}  // namespace demolish::sculptor
