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

/// Joins all items in a folder of results: specimens.csv, probability.csv, breakage.json, figure_1.svg,
/// figure_2a.svg, figure_2b.svg. Returns the table. Throws InputFileError when an item is missing,
/// OutputError.
std::string gatherResults(const BreakagePlan& plan, const std::filesystem::path& folder);

}  // namespace demolish
