// SPDX-License-Identifier: Apache-2.0
// Random packings of spheres with bonds across their gaps: the bodies of the breakage experiment (physics.md
// C.1), as bars.
#pragma once
#include <memory>
#include <vector>

#include "sim_cuda/api/breakable_body.h"

namespace demolish::tests {

struct PackedSpheres {
    std::shared_ptr<BreakableBody> body;  ///< one particle a sphere; bonds from gap to gap
    std::vector<double> radius;           ///< m, of each sphere
    double volume = 0;                    ///< m^3, of the region that they were cut from
    double bonds_per_particle = 0;        ///< z, each bond counted at both ends
};

/// Spheres of mean diameter d (m), radii spread evenly by +-12 %, solid fraction 0.60, in a random packing
/// without overlaps; those whose centre lies in a box of these sides (m; centred in x and z, standing on y =
/// 0), bonded where the gap is at most `gap` (R1 + R2).
PackedSpheres packSpheres(const Double3& sides, double diameter, double gap, uint64_t seed);

}  // namespace demolish::tests
