// SPDX-License-Identifier: Apache-2.0
// What is to be simulated, in which order, and in which portions: the same on every machine.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/breakage/experiment.h"

namespace demolish {

/// One specimen and its impact.
struct BreakageRun {
    uint32_t experiment = 0;  ///< of the plan's
    uint32_t size = 0;        ///< 0 small, 1 large
    uint32_t packing = 0;
    uint32_t speed = 0;   ///< of velocitiesOf()
    double velocity = 0;  ///< m/s
};

struct BreakagePlan {
    std::vector<BreakageExperiment> experiments;  ///< at least one; the first is the default reading
    uint32_t batch = 600;                         ///< most specimens in one simulation

    /// Runs of each item: one experiment at most, in the order size, speed, packing. An item is one
    /// simulation, and what comes out of it depends on nothing but the plan and its number.
    std::vector<std::vector<BreakageRun>> items() const;

    std::string json() const;
    /// 16 hexadecimal digits that stand for the whole plan.
    std::string fingerprint() const;
};

/// Writes DIR/plan.json, or makes sure that the one there says the same. Throws UsageError if it says
/// something else, OutputError.
void settlePlan(const BreakagePlan& plan, const std::filesystem::path& folder);
/// Throws InputFileError.
BreakagePlan readPlan(const std::filesystem::path& folder);

/// The whole file; throws InputFileError.
std::string readTextFile(const std::filesystem::path& file);

}  // namespace demolish
