// SPDX-License-Identifier: Apache-2.0
// One bond for every pair of cells that share enough face (geometry.md 5).
#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

namespace {

constexpr double kLeastArea = 0.02;  // h^2: below it a bond only costs time step

}  // namespace

std::vector<BondGeometry> makeBonds(const CellComplex& complex, double spacing) {
    std::vector<BondGeometry> bonds;
    const double least = kLeastArea * spacing * spacing;
    for (size_t first = 0; first < complex.faces.size();) {
        BondGeometry bond;
        bond.i = complex.faces[first].cell_a;
        bond.j = complex.faces[first].cell_b;
        Double3 moment;
        size_t end = first;
        for (; end < complex.faces.size() && complex.faces[end].cell_a == bond.i &&
               complex.faces[end].cell_b == bond.j;
             ++end) {
            bond.area += complex.faces[end].area;
            moment += complex.faces[end].centroid * complex.faces[end].area;
        }
        first = end;
        if (bond.area < least) continue;
        bond.centroid = moment * (1 / bond.area);
        const Double3 axis = complex.seeds[bond.j] - complex.seeds[bond.i];
        bond.length = length(axis);
        bond.normal = axis * (1 / bond.length);
        bonds.push_back(bond);
    }
    return bonds;
}

}  // namespace demolish
