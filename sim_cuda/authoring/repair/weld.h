// SPDX-License-Identifier: Apache-2.0
// One vertex where the file has several that all but coincide.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

inline constexpr double kWeldShare = 1e-5;  ///< of the diagonal

/// Joins vertices within `tolerance` (m) of each other: the first one stays where it is, a later one goes to
/// the nearest that stayed. Drops triangles that lost a corner by it; collinear ones stay, since they close
/// their neighbours. Returns how many vertices went.
size_t weldNear(RepairMesh& repair, double tolerance);

}  // namespace demolish
