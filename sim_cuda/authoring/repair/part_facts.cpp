// SPDX-License-Identifier: Apache-2.0
// One pass for the boxes, one for the sums: volumes are taken about the middle of their own part.
#include "sim_cuda/authoring/repair/part_facts.h"

#include <cmath>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

double PartFacts::diagonal() const {
    return length(upper - lower);
}

bool isFlat(double volume, double area, double diagonal) {
    constexpr double kFlat = 0.002;
    return std::abs(volume) < kFlat * area * diagonal;
}

std::vector<PartFacts> factsOfParts(const RepairMesh& filled, const std::vector<char>& patch_touched) {
    std::vector<PartFacts> facts(filled.parts);
    for (size_t t = 0; t < filled.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            PartFacts& part = facts[filled.part[t]];
            part.lower = minimum(part.lower, filled.at(t, k));
            part.upper = maximum(part.upper, filled.at(t, k));
        }
    for (size_t t = 0; t < filled.size(); ++t) {
        PartFacts& part = facts[filled.part[t]];
        const bool is_cap = filled.source[t] == kNoSource;
        (is_cap ? part.cap_area : part.area) += filled.area(t);
        part.was_open = part.was_open || is_cap;
        part.was_touched = part.was_touched ||
                           (filled.patch[t] < patch_touched.size() && patch_touched[filled.patch[t]] != 0);
        const Double3 middle = (part.lower + part.upper) * 0.5;
        part.volume +=
            dot(filled.at(t, 0) - middle, cross(filled.at(t, 1) - middle, filled.at(t, 2) - middle)) / 6;
    }
    return facts;
}

}  // namespace demolish
