// SPDX-License-Identifier: Apache-2.0
// Round specimens of packed spheres, bonded across small gaps: the particles of the paper's 4.1.
#pragma once
#include <cstdint>
#include <memory>

#include "sim_cuda/api/breakable_body.h"

namespace demolish {

struct SphereSpecimen {
    double diameter = 24e-6;       ///< m
    uint32_t grains = 500;         ///< spheres, 2..100,000
    double solid_fraction = 0.60;  ///< their volume over the specimen's, 0.05..0.62
    double radius_scatter = 0.12;  ///< radii are uniform within 1 +- this, 0..0.5
    double bond_gap = 0.20;        ///< g: a bond wherever the gap is at most g (R1 + R2), 0..0.4
    double bond_ratio = 0.5;       ///< a* = a_b / (2 R*), 0.1..0.9; gives the bonds their area pi a_b^2
    uint64_t seed = 1;
};

/// Random packing, centred on the origin; grains reach beyond the diameter by less than a tenth of their
/// radius, contact radii never overlap. The same for equal values on every machine. Its bonds are for
/// BondLaw::kSpheres; nothing to draw. Throws UsageError outside the ranges.
std::shared_ptr<const BreakableBody> packSphereSpecimen(const SphereSpecimen& specimen);

/// Bonds a grain, z.
double coordinationOf(const BreakableBody& body);

}  // namespace demolish
