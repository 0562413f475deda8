// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/border_teeth.h"

namespace demolish {
namespace {

constexpr double kGradient = 0.05;  // spacings

}  // namespace

double borderTeeth(const ToughField& tough, const std::vector<BondGeometry>& bonds,
                   const std::vector<uint32_t>& cell, double spacing) {
    double faces = 0, border = 0;
    for (const BondGeometry& bond : bonds) {
        const uint32_t a = cell[bond.i], b = cell[bond.j];
        if (a == b) continue;
        const Double3 towards_a = normalized(borderGradient(tough, bond.centroid, a, b, kGradient * spacing));
        faces += bond.area;
        border -= bond.area * dot(bond.normal, towards_a);
    }
    return border > 0 ? faces / border : 1;
}

}  // namespace demolish
