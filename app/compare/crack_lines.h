// SPDX-License-Identifier: Apache-2.0
// How even a line is: against itself smoothed.
#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace demolish {

/// Corners of a line, m; closed where the last is the first.
using Line = std::vector<glm::dvec3>;

struct LineMeasure {
    double deviation = 0;  ///< rms, over h
    double turning = 0;    ///< rad per h
    double length = 0;     ///< h, of all lines that were long enough
};

/// Lines of 3 h and more, each sampled every 0.1 h, against their Gaussian mean of sigma h.
LineMeasure measureLines(const std::vector<Line>& lines, double h);

}  // namespace demolish
