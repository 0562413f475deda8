// What a capture or benchmark run found, for people (a table) and for programs (JSON, SI units).
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/session/built_shot.h"
#include "app/session/frame_times.h"

namespace demolish {

struct RunReport {
    std::string gl_renderer = "none";
    std::string transfer = "none";  ///< interop, copy, host; none without drawing
    std::string transfer_note;
    uint32_t width = 0, height = 0;
    uint64_t frames = 0;
    double wall_seconds = 0;
    FrameSummary times;
    std::optional<EnergyLedger> energy;  ///< in place of the solver's, where that kept no ledger
    std::vector<std::pair<std::string, double>> draw_passes;  ///< median GPU time of each pass, ms
};

/// Reads stats and hash from the solver; call Solver::measure() before.
std::string reportJson(const BuiltShot& built, const RunReport& report);
std::string reportTable(const BuiltShot& built, const RunReport& report);

/// "AMD EPYC 9654, 2 threads".
std::string machineName();
unsigned threadsInUse();

}  // namespace demolish
