// SPDX-License-Identifier: Apache-2.0
// Does something grow? Samples of equal rounds, the first third of them for warming up.
#pragma once
#include <string>
#include <vector>

namespace demolish::fuzz {

/// What a process holds.
struct Usage {
    double resident = 0, gpu = 0;  ///< MiB
    double files = 0;              ///< open ones
};

/// Growth of a straight line through the samples after the first third, from its first to its last one.
/// Medians of all slopes (Theil and Sen), so that a single high sample does not count. 0 for fewer than two.
double trend(const std::vector<double>& samples);

/// One sentence for each of the three that grows; also when there are too few rounds to tell.
std::vector<std::string> growth(const std::vector<Usage>& samples);

}  // namespace demolish::fuzz
