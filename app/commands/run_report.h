// SPDX-License-Identifier: Apache-2.0
// What a capture or benchmark run found, for people (a table) and for programs (JSON, SI units).
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/session/built_shot.h"
#include "app/session/energy_balance.h"
#include "app/session/frame_times.h"

namespace demolish {

struct RunReport {
    std::string mode = "simulate and draw";
    std::string gl_renderer = "none", gl_version, quality;  ///< quality: draft or full
    std::string transfer = "none";                          ///< interop, copy, host; none without drawing
    std::string transfer_note;
    uint32_t width = 0, height = 0;
    uint64_t frames = 0;
    double wall_seconds = 0;
    double frame_seconds = 0;  ///< the least that a frame simulated, s; 0: not looked at
    FrameSummary times;
    std::vector<PhaseSummary> phases;                         ///< rows of a benchmark; none in other reports
    std::optional<EnergyBalance> energy;                      ///< none where no ledger was kept
    std::vector<std::pair<std::string, double>> draw_passes;  ///< median GPU time of each pass, ms
};

/// For people. Reads stats and hash from the solver; call Solver::measure() before.
std::string reportTable(const BuiltShot& built, const RunReport& report);
/// What a line of a CSV file needs to be told from other runs', name and value.
std::vector<std::pair<std::string, std::string>> runFacts(const BuiltShot& built, const RunReport& report);

}  // namespace demolish
