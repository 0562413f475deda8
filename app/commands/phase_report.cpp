// SPDX-License-Identifier: Apache-2.0
// One list of columns serves JSON and CSV, so that they cannot drift apart.
#include "app/commands/phase_report.h"

#include <nlohmann/json.hpp>

#include "app/commands/text_table.h"
#include "app/session/json_text.h"

namespace demolish {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers of a row in the order of the columns; null where there is none.
Json rowJson(const PhaseSummary& row, size_t bodies) {
    const FrameSummary& t = row.times;
    Json json = {{"from_s", row.phase.from}, {"to_s", row.phase.to}, {"frames", t.frames}};
    const bool timed = t.frames > 0;
    const auto add = [&](const char* key, auto value, bool known) {
        json[key] = known ? Json(value) : Json(nullptr);
    };
    add("fps_median", t.fps_median, timed);
    add("fps_mean", t.fps_mean, timed);
    add("paper_fps", row.phase.paper_fps, row.phase.paper_fps > 0);
    add("ratio", row.ratio(), timed && row.phase.paper_fps > 0);
    add("fps_p1", t.fps_p1, timed);
    add("frame_ms_median", t.frame_ms_median, timed);
    add("frame_ms_p99", t.frame_ms_p99, timed);
    add("frame_ms_worst", t.frame_ms_worst, timed);
    add("sim_ms", t.sim_ms, timed);
    add("transfer_ms", t.transfer_ms, timed);
    add("draw_ms", t.draw_ms, timed);
    add("rest_ms", t.rest_ms, timed);
    add("substeps", t.substeps, timed);
    add("particles", t.particles, timed);
    add("awake_particles", t.awake_particles, timed);
    add("bonded_particles", t.bonded_particles, timed);
    add("bodies", bodies, true);
    add("awake_bodies", t.awake_bodies, timed);
    add("fragments", t.fragments, timed);
    add("rigid_fragments", t.rigid_fragments, timed);
    add("sleeping_fragments", t.sleeping_fragments, timed);
    add("triangles", t.triangles, timed);
    return json;
}

std::string speedLine(const PhaseSummary& row) {
    const FrameSummary& t = row.times;
    const bool in_paper = row.phase.paper_fps > 0;
    const std::string paper = in_paper ? formatted("%.0f", row.phase.paper_fps) : "-";
    const std::string name = formatted("  %-16s", row.phase.name.c_str());
    if (t.frames == 0)
        return name + formatted(" %6d %9s %8s %8s %7s %8s %8s %8s\n", 0, "-", "-", paper.c_str(), "-", "-",
                                "-", "-");
    const std::string ratio = in_paper ? formatted("%.2f", row.ratio()) : "-";
    return name + formatted(" %6zu %9.1f %8.1f %8s %7s %8.1f %8.2f %8.2f\n", t.frames, t.fps_median,
                            t.fps_mean, paper.c_str(), ratio.c_str(), t.fps_p1, t.frame_ms_p99,
                            t.frame_ms_worst);
}

std::string stageLine(const PhaseSummary& row, size_t bodies) {
    const FrameSummary& t = row.times;
    if (t.frames == 0) return "";
    const std::string awake = formatted("%.0f / %u", t.awake_particles, t.particles);
    const std::string awake_bodies = formatted("%.0f / %zu", t.awake_bodies, bodies);
    return formatted("  %-16s %7.2f %8.3f %6.2f %6.2f %8.0f  %17s %8s %9u %9llu\n", row.phase.name.c_str(),
                     t.sim_ms, t.transfer_ms, t.draw_ms, t.rest_ms, t.substeps, awake.c_str(),
                     awake_bodies.c_str(), t.fragments, static_cast<unsigned long long>(t.triangles));
}

/// Six digits are more than a timing holds.
std::string numberText(const Json& value) {
    if (value.is_null()) return "";
    return value.is_number_float() ? formatted("%.6g", value.get<double>()) : jsonText(value, -1);
}

}  // namespace

std::string phaseTable(std::span<const PhaseSummary> rows, size_t bodies) {
    constexpr const char* kHeading = "  %-16s %6s %9s %8s %8s %7s %8s %8s %8s\n";
    std::string table =
        formatted(kHeading, "", "", "FPS", "FPS", "paper's", "", "p1", "p99", "worst") +
        formatted(kHeading, "phase", "frames", "median", "mean", "FPS", "ratio", "FPS", "ms", "ms");
    for (const auto& row : rows) table += speedLine(row);
    table += formatted("\n  %-16s %7s %8s %6s %6s %8s  %17s %8s %9s %9s\n", "", "sim", "transfer", "draw",
                       "rest", "", "awake", "awake", "", "") +
             formatted("  %-16s %7s %8s %6s %6s %8s  %17s %8s %9s %9s\n", "phase", "ms", "ms", "ms", "ms",
                       "substeps", "particles", "bodies", "fragments", "triangles");
    for (const auto& row : rows) table += stageLine(row, bodies);
    return table +
           "  Medians of the row's frames; fragments and triangles: the most. A particle is awake that costs "
           "anything.\n"
           "  While it breaks: from the first frame in which bonds break to the last; breaking: those in "
           "which "
           "they do.\n";
}

Json phaseJson(std::span<const PhaseSummary> rows, size_t bodies) {
    Json all = Json::array();
    for (const auto& row : rows) {
        Json json = {{"phase", row.phase.name}};
        json.update(rowJson(row, bodies));
        all.push_back(json);
    }
    return all;
}

std::string phaseCsv(std::span<const PhaseSummary> rows, size_t bodies,
                     const std::vector<std::pair<std::string, std::string>>& run) {
    std::string text;
    for (const auto& row : rows) {
        std::vector<std::string> names, values;
        for (const auto& [name, value] : run) {
            names.push_back(name);
            values.push_back(value);
        }
        names.emplace_back("phase");
        values.push_back(row.phase.name);
        const Json numbers = rowJson(row, bodies);
        for (const auto& [key, value] : numbers.items()) {
            names.push_back(key);
            values.push_back(numberText(value));
        }
        if (text.empty()) text = csvLine(names);
        text += csvLine(values);
    }
    return text;
}

}  // namespace demolish
