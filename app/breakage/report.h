// SPDX-License-Identifier: Apache-2.0
// A sweep as tables: for people, for spreadsheets, for programs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/breakage/statistics.h"

namespace demolish {

/// A row a specimen.
std::string specimensCsv(const BreakagePlan& plan, std::span<const ItemResult> results);
/// A row an experiment, size and velocity, with Wilson intervals and children.
std::string probabilityCsv(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics);
/// Everything, with the settings and the comparison with the paper.
std::string breakageJson(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics);
/// For the terminal.
std::string breakageTable(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics);

struct GatheredResults {
    std::string table;     ///< breakageTable()
    bool has_png = false;  ///< figures were drawn as PNG too
};
/// Joins all items in a folder of results: specimens.csv, probability.csv, breakage.json; figure_1, figure_2a
/// and figure_2b as SVG, and as PNG where this machine can (png_figure.h). Throws InputFileError when an item
/// is missing, OutputError.
GatheredResults gatherResults(const BreakagePlan& plan, const std::filesystem::path& folder);

}  // namespace demolish
