// SPDX-License-Identifier: Apache-2.0
// Relaxed packing of exactly N seeds inside a mesh (geometry.md 1 a-e).
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

/// Told the fraction done; returns false to cancel.
using PackingProgress = std::function<bool(double fraction)>;

/// Exactly `count` >= 1 seeds, all inside (winding number > 0), isotropic, depth >= 0.45 h where the solid
/// allows it, in general position; independent of the thread count. `volume` (m^3, > 0) is the mesh's. Throws
/// Cancelled, and InputFileError where not even a millionth of h fits between the walls.
std::vector<Double3> packSeeds(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid,
                               double volume, uint32_t count, uint64_t seed,
                               const PackingProgress& progress = {});

}  // namespace demolish
