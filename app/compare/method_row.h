// SPDX-License-Identifier: Apache-2.0
// One method in a comparison: how fast it ran, and what became of the bodies, in numbers.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/compare/crack_lines.h"
#include "app/compare/fragment_map.h"
#include "app/session/frame_times.h"
#include "app/session/session.h"

namespace demolish {

struct MethodRow {
    std::string name;  ///< of the method, or of another program
    std::string device;
    double fps_whole = 0, fps_broken = 0;  ///< medians; 0: no frame of that kind
    double frame_ms_worst = 0;
    double sim_ms = 0;  ///< median, of the broken frames
    PieceSizes sizes;
    LineMeasure outline;                ///< of crack lines between large pieces; length 0 without drawing
    double moved = 0;                   ///< distance of the maps when the impact is turned
    size_t turned_pieces = 0;           ///< of that run
    std::optional<double> closure;      ///< of its energy books, in that run
    std::optional<double> most_energy;  ///< of a program without books: after any frame, over what came in
    uint64_t state_hash = 0;            ///< at the end
};

/// The frames before the first phase's end and of the last phase; of a shot without phases those before the
/// first bond broke, and after the last.
void addTimes(std::span<const FrameSample> samples, std::span<const Phase> phases, MethodRow& row);

/// The piece of every cell of the bodies, as of now.
std::vector<uint32_t> fragmentMap(Session& session);

/// How even the lines of its cracks are, all bodies together, as drawn; the shot must have been built with
/// draw geometry and its frames exported.
LineMeasure outlineOf(Session& session);

/// The same shot hit from another side: its balls' ways turned by 90 degrees about the vertical; a dropped
/// body by as much about x. `body`: any filling.
Shot turnedImpact(const Shot& shot, const BreakableBody& body);

}  // namespace demolish
