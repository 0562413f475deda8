// SPDX-License-Identifier: Apache-2.0
// Strength of bonds from the colours that are painted on the outside above them.
#pragma once
#include <vector>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/api/paint.h"
#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

/// Of each bond, by paintedStrength() of the least value along its way from seed to seed, so that lines
/// narrower than a cell count as well. The value of a place inside is that of the nearest point of the
/// outside. `seeds` (m) of the cells.
std::vector<double> paintedBonds(const TriangleMesh& mesh, const MeshQueries& queries,
                                 const std::vector<Double3>& seeds, const std::vector<BondGeometry>& bonds,
                                 const PaintedStrength& painted);

}  // namespace demolish
