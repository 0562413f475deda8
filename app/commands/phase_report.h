// SPDX-License-Identifier: Apache-2.0
// The phases of a benchmark beside the paper's numbers: for people (a table) and for programs (JSON, CSV).
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/session/frame_times.h"

namespace demolish {

/// Two blocks, a line for each row: speed beside the paper's, then where the time goes and on what.
std::string phaseTable(std::span<const PhaseSummary> rows, size_t bodies);

/// SI units, but ms for times; a row in which no frame was timed has null for its numbers.
nlohmann::ordered_json phaseJson(std::span<const PhaseSummary> rows, size_t bodies);

/// A header line and a line for each row. `run` is what all rows share, name and value, and comes first in
/// each line, so that files of several runs can be put together.
std::string phaseCsv(std::span<const PhaseSummary> rows, size_t bodies,
                     const std::vector<std::pair<std::string, std::string>>& run);

}  // namespace demolish
