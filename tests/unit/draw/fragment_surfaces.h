// SPDX-License-Identifier: Apache-2.0
// The closed surface of every fragment, put together as the renderer would, and what makes it a solid.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "sim_cuda/api/fracture_geometry.h"

namespace demolish::test {

using Soup = std::vector<std::array<Float3, 3>>;

/// One soup a fragment (0 .. fragment_count-1): exterior of its cells, and the interior faces to other
/// fragments. `pool` are the pool positions to use (at rest, or relaxed).
std::vector<Soup> fragmentSurfaces(const FractureGeometry& geometry,
                                   const std::vector<uint32_t>& fragment_of_cell, uint32_t fragment_count,
                                   const std::vector<Float3>& pool);

/// Edges (by the bits of their end positions) that are not used equally often in both directions.
size_t openEdges(const Soup& soup);

/// m^3, by the divergence theorem in double.
double enclosedVolume(const Soup& soup);

/// A random fragment for every cell: seeds grow at random over the faces, so fragments have all shapes and
/// sizes.
std::vector<uint32_t> randomFragments(const FractureGeometry& geometry, uint32_t cell_count,
                                      uint32_t fragment_count, uint32_t seed);

}  // namespace demolish::test
