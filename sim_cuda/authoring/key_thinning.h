// SPDX-License-Identifier: Apache-2.0
// Few moments that tell a motion as well as many do.
#pragma once
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// s, 0 and moments at and between a file's keys, ascending, at most `most` + 2 of them: what turns about
/// something goes in no straight line. `times`: of the keys, ascending, above 0, not empty.
std::vector<double> looksAt(const std::vector<double>& times, size_t most);

/// Indices of the moments that are needed, the first and the last among them, so that straight lines between
/// them miss no vector of the others by more than 1. `vectors`: of each moment the same number of them, in
/// units of the error that each may have.
std::vector<size_t> neededMoments(const std::vector<double>& times,
                                  const std::vector<std::vector<Double3>>& vectors);

}  // namespace demolish
