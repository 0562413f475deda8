// SPDX-License-Identifier: Apache-2.0
// How even a line is: against itself smoothed.
#pragma once
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish::test {

struct LineMeasure {
    double deviation = 0;  ///< rms, over h
    double turning = 0;    ///< rad per h
    double length = 0;     ///< h, of all lines that were long enough
};

/// Lines of 3 h and more, each sampled every 0.1 h, against their Gaussian mean of sigma h.
LineMeasure measureLines(const std::vector<std::vector<Double3>>& lines, double h);

}  // namespace demolish::test
