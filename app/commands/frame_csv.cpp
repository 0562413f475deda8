// SPDX-License-Identifier: Apache-2.0
// Every frame of a run in a line of its own, for those who plot frame times themselves: s simulated at its
// end, the phase that it lies in, ms by stage, bonds that broke in it, and what it was spent on. The columns
// are named as those of the phases.
#include <algorithm>

#include "app/commands/run_formats.h"
#include "app/commands/text_table.h"

namespace demolish {
namespace {

std::string shortNumber(double value) {
    return formatted("%.6g", value);
}

}  // namespace

std::string framesCsv(FinishedRun& run) {
    const std::span<const Phase> phases = run.built.shot.phases;
    std::string text =
        csvLine({"frame", "time_s", "phase", "frame_ms", "sim_ms", "transfer_ms", "draw_ms", "rest_ms",
                 "bonds_broken_now", "substeps", "list_rebuilds", "awake_particles", "bonded_particles",
                 "carried_particles", "fragments", "rigid_fragments", "sleeping_fragments", "triangles"});
    uint32_t broken_before = 0;
    for (const FrameSample& sample : run.samples) {
        const FrameStats& stats = sample.stats;
        const Phase* phase = phaseAt(phases, stats.time);
        const uint32_t broken = stats.bonds_broken - std::min(stats.bonds_broken, broken_before);
        broken_before = stats.bonds_broken;
        text +=
            csvLine({std::to_string(stats.frame), shortNumber(stats.time),
                     phase != nullptr ? phase->name : "", shortNumber(sample.frame_ms),
                     shortNumber(sample.sim_ms), shortNumber(sample.transfer_ms), shortNumber(sample.draw_ms),
                     shortNumber(sample.restMs()), std::to_string(broken), std::to_string(stats.substeps),
                     std::to_string(stats.list_rebuilds), std::to_string(stats.awake_particles),
                     std::to_string(stats.bonded_particles), std::to_string(stats.carried_particles),
                     std::to_string(stats.fragments), std::to_string(stats.rigid_fragments),
                     std::to_string(stats.sleeping_fragments), std::to_string(sample.triangles)});
    }
    return text;
}

}  // namespace demolish
