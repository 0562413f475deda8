// SPDX-License-Identifier: Apache-2.0
// Relaxed packing of exactly N seeds inside a mesh (geometry.md 1 a-e).
#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/spacing_field.h"

namespace demolish {

/// Told the fraction done; returns false to cancel.
using PackingProgress = std::function<bool(double fraction)>;

/// Moves relaxed seeds (m); none is added or taken away.
using SeedShaping = std::function<void(std::vector<Double3>& seeds)>;

/// Exactly `count` >= 1 seeds, all inside (winding number > 0), isotropic, so far apart as `spacing` says, at
/// a depth >= 0.45 of that where the solid allows it, in general position; independent of the thread count.
/// `shape` comes after the rounds of repulsion; what it leaves outside is brought back. Throws Cancelled, and
/// InputFileError where not even a millionth of h fits between the walls.
std::vector<Double3> packSeeds(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid,
                               const SpacingField& spacing, uint32_t count, uint64_t seed,
                               const PackingProgress& progress = {}, const SeedShaping& shape = {});
/// As large everywhere as it has to be; `volume` (m^3, > 0) is the mesh's.
inline SpacingField evenSpacing(double volume, uint32_t count) {
    return SpacingField(std::cbrt(volume / count));
}

}  // namespace demolish
