// SPDX-License-Identifier: Apache-2.0
// How even a line is: against itself smoothed.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace demolish {

/// On the outside of a body.
struct LineCorner {
    glm::dvec3 place;   ///< m
    glm::dvec3 normal;  ///< unit, of the outside there
};
/// Closed where the last corner is at the place of the first.
using Line = std::vector<LineCorner>;

struct LineMeasure {
    double deviation = 0;  ///< rms, over h
    double sideways = 0;   ///< the same within the outside: a straight cut round a limb has none
    double turning = 0;    ///< rad per h
    double length = 0;     ///< h, of all lines that were long enough
};

/// Lines of 3 h and more, each sampled every 0.1 h, against their Gaussian mean of sigma h.
LineMeasure measureLines(const std::vector<Line>& lines, double h);

}  // namespace demolish
