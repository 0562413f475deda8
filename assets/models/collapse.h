// SPDX-License-Identifier: Apache-2.0
// Decimates a closed surface to an exact number of triangles.
#pragma once
#include <functional>

#include "assets/models/surface.h"

namespace demolish::sculptor {

/// Quadric edge collapse, cheapest first, ties by vertex number. An edge that fails the link, turn or sliver
/// test is put aside; when none is left the queue is filled again with all edges, and when a whole pass gains
/// less than 0.5 % the turn and sliver limits are loosened by 0.7. `weight(p)` multiplies the error of
/// triangles centred at p. Keeps closedness, orientation and genus. Throws std::runtime_error when the count
/// is odd, above what the surface has, or out of reach.
Surface collapseTo(const Surface& surface, std::size_t triangles, const std::function<double(Vec3)>& weight);

}  // namespace demolish::sculptor
