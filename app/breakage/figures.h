// SPDX-License-Identifier: Apache-2.0
// The paper's Figs 1, 2a and 2b from a sweep, with what its text states drawn in.
#pragma once
#include <string>
#include <vector>

#include "app/breakage/statistics.h"

namespace demolish {

/// Fig 1: probability of breakage against velocity, Wilson intervals on the first reading, the others as thin
/// lines. SVG.
std::string probabilityFigure(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics);

/// Fig 2a (size 0), 2b (size 1): how many specimens broke into how many children, of the first reading. SVG.
std::string childrenFigure(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics,
                           uint32_t size);

}  // namespace demolish
