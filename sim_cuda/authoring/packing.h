// Relaxed packing of exactly N seeds inside a mesh (geometry.md 1 a-e).
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

/// Exactly `count` seeds, isotropic, depth >= 0.45 h where the solid allows it; independent of the thread count.
std::vector<Double3> packSeeds(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid, double volume,
                               uint32_t count, uint64_t seed);

}  // namespace demolish
