// SPDX-License-Identifier: Apache-2.0
// Integer winding numbers on a coarse grid: what is inside once, more than once, or less than not at all.
#pragma once
#include <vector>

#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct WindingSamples {
    size_t inside = 0;    ///< winding number above 0
    size_t negative = 0;  ///< below 0
    size_t doubled = 0;   ///< by how much those inside are above 1, summed
    double volume = 0;    ///< m^3, of what is inside, counted once
    std::vector<Double3> doubled_points;

    double overlap() const { return inside > 0 ? double(doubled) / double(inside) : 0; }
    /// More than noise lies inside out.
    bool isInsideOut() const { return double(negative) > 0.002 * double(inside) + 2; }
};

/// Of a closed mesh, at some 30,000 points of its box, or eight times as many where few of them are inside.
WindingSamples sampleWinding(const TriangleMesh& mesh);

/// How many of the same points the winding number of `closed` and the generalized one of it without `caps`
/// disagree on, as a share of those inside. The winding numbers of the two add up to that of `closed`: only
/// the caps, which are few, are summed up.
double windingDifference(const TriangleMesh& closed, const TriangleMesh& caps);

}  // namespace demolish
