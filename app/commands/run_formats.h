// SPDX-License-Identifier: Apache-2.0
// The files that a finished run can be written to: the list of formats. A format more is a function in a file
// of its own, its declaration and its line here.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "app/commands/run_report.h"
#include "app/session/built_shot.h"
#include "app/session/frame_times.h"

namespace demolish {

struct FinishedRun {
    const BuiltShot& built;  ///< measured
    RunReport& report;
    std::span<const FrameSample> samples;  ///< of the timed frames
    /// Where the energy of these frames went; may run them once more. Empty: the report knows.
    std::function<std::optional<EnergyBalance>()> energy{};
};

// Each makes a file's whole text and may throw.
std::string reportJson(FinishedRun& run);     // run_report.cpp
std::string phasesCsv(FinishedRun& run);      // run_report.cpp
std::string framesCsv(FinishedRun& run);      // frame_csv.cpp
std::string frameCurveSvg(FinishedRun& run);  // frame_curve.cpp

struct RunFormat {
    const char* capture_option;  ///< of demolish capture; null: it does not offer it
    const char* bench_option;    ///< of demolish bench; likewise
    const char* help;
    std::string (*make)(FinishedRun& run);
};

inline constexpr RunFormat kRunFormats[] = {
    {"--report", "--json", "Report of the run, JSON, SI units", reportJson},
    {nullptr, "--csv", "A line for each phase, CSV", phasesCsv},
    {nullptr, "--frame-csv", "A line for each frame, CSV", framesCsv},
    {nullptr, "--curve", "Frame time over the shot, stage by stage, SVG", frameCurveSvg},
};

}  // namespace demolish
