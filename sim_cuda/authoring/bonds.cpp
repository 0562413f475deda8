// SPDX-License-Identifier: Apache-2.0
// One bond for every pair of cells that share enough face (geometry.md 5).
#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

namespace {

constexpr double kLeastArea = 0.02;  // h^2, of the finer cell: below it a bond only costs time step

}  // namespace

std::vector<BondGeometry> makeBonds(const CellComplex& complex, double spacing,
                                    const std::vector<double>& cell_spacing) {
    std::vector<BondGeometry> bonds;
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
        const double finer =
            cell_spacing.empty() ? spacing : std::min(cell_spacing[bond.i], cell_spacing[bond.j]);
        if (bond.area < kLeastArea * finer * finer) continue;
        bond.centroid = moment * (1 / bond.area);
        const Double3 axis = complex.seeds[bond.j] - complex.seeds[bond.i];
        bond.length = length(axis);
        bond.normal = axis * (1 / bond.length);
        bonds.push_back(bond);
    }
    return bonds;
}

}  // namespace demolish
