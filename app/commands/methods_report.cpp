// SPDX-License-Identifier: Apache-2.0
// Table and JSON of the comparison.
#include <nlohmann/json.hpp>

#include "app/commands/build_version.h"
#include "app/commands/machine_facts.h"
#include "app/commands/methods_bench.h"
#include "app/commands/text_table.h"
#include "app/session/json_text.h"

namespace demolish {
namespace {

using Json = nlohmann::ordered_json;

/// What the paper says of each (4.4, Fig. 5); FPS 0: no number.
struct PaperMethod {
    const char* name;
    double fps;
};
PaperMethod paperMethod(const std::string& name) {
    const std::optional<Method> method = methodOf(name);
    if (!method) return {"-", 0};
    switch (*method) {
        case Method::kPatternAtImpact:
            return {"Method 1", 130};
        case Method::kHeavy:
            return {"Method 2", 20};
        case Method::kPattern:
            return {"Method 3", 35};
        case Method::kCores:
            return {"Method 4", 0};
        case Method::kOurs:
            break;
    }
    return {"its own", 60};
}

std::string orDash(double value, const char* format) {
    return value > 0 ? formatted(format, value) : "-";
}

/// Without books there is only a bound.
std::string energyOf(const MethodRow& row) {
    if (row.closure) return formatted("%.4f", *row.closure);
    return row.most_energy ? formatted("<=%.3f", *row.most_energy) : "-";
}

std::string lineOf(const MethodRow& row) {
    const PaperMethod paper = paperMethod(row.name);
    const bool lines = row.outline.length > 0;
    return formatted("  %-18s %-9s %6s %8s %8s %8.3g %7zu %7zu %5zu %8.1f %7.2f %9s %8s\n", row.name.c_str(),
                     paper.name, orDash(paper.fps, "%.0f").c_str(), orDash(row.fps_whole, "%.4g").c_str(),
                     orDash(row.fps_broken, "%.4g").c_str(), row.sim_ms, row.sizes.pieces, row.sizes.single,
                     row.sizes.half, 100 * row.sizes.largest, row.moved,
                     lines ? formatted("%.3f/%.2f", row.outline.deviation, row.outline.turning).c_str() : "-",
                     energyOf(row).c_str());
}

Json rowJson(const MethodRow& row) {
    const PaperMethod paper = paperMethod(row.name);
    Json json = {{"name", row.name},
                 {"paper", paper.name},
                 {"paper_fps", paper.fps > 0 ? Json(paper.fps) : Json()},
                 {"device", row.device},
                 {"fps_whole", row.fps_whole},
                 {"fps_broken", row.fps_broken},
                 {"sim_ms", row.sim_ms},
                 {"frame_ms_worst", row.frame_ms_worst},
                 {"pieces", row.sizes.pieces},
                 {"single_cells", row.sizes.single},
                 {"pieces_of_half", row.sizes.half},
                 {"largest_share", row.sizes.largest},
                 {"map_distance", row.moved},
                 {"pieces_from_the_side", row.turned_pieces},
                 {"energy_closure", row.closure ? Json(*row.closure) : Json()}};
    if (row.most_energy) json["most_energy"] = *row.most_energy;
    if (row.state_hash != 0)
        json["state_hash"] = formatted("0x%016llx", static_cast<unsigned long long>(row.state_hash));
    if (row.outline.length > 0)
        json["outline"] = {{"deviation_h", row.outline.deviation},
                           {"turning_rad_per_h", row.outline.turning},
                           {"length_h", row.outline.length}};
    return json;
}

}  // namespace

std::string methodsTable(std::span<const MethodRow> rows, const MethodsPlace& place) {
    std::string table = formatted("  %s, %u particles in %u %s, %llu frames; %s\n", place.scene.c_str(),
                                  place.particles, place.bodies, place.bodies == 1 ? "body" : "bodies",
                                  static_cast<unsigned long long>(place.frames), machineName().c_str()) +
                        "  drawn by " + place.drawn_by + "\n\n";
    table += formatted("  %-18s %-9s %6s %8s %8s %8s %7s %7s %5s %8s %7s %9s %8s\n", "", "paper", "FPS",
                       "FPS", "FPS", "sim ms", "", "single", "half", "largest", "map", "outline", "energy");
    table +=
        formatted("  %-18s %-9s %6s %8s %8s %8s %7s %7s %5s %8s %7s %9s %8s\n", "method", "", "there",
                  "whole", "broken", "broken", "pieces", "cells", "in", "%", "moved", "h, rad/h", "found");
    for (const MethodRow& row : rows) table += lineOf(row);
    table +=
        "\n  half in: the largest pieces that hold half of the cells; map moved: 1 - adjusted Rand index of "
        "which\n  cells are of one piece, when the impact comes from another side (0: the same pieces, 1: as "
        "by chance);\n  outline: cracks between large pieces off their own mean line, and how much they "
        "turn; "
        "energy found\n  again of what the impact from the other side brought in.\n";
    return table;
}

std::string methodsJson(std::span<const MethodRow> rows, const MethodsPlace& place) {
    Json json = {{"scene", place.scene},      {"particles", place.particles}, {"bodies", place.bodies},
                 {"frames", place.frames},    {"drawn_by", place.drawn_by},   {"machine", machineName()},
                 {"threads", threadsInUse()}, {"driver", gpuDriver()},        {"version", buildVersion()},
                 {"methods", Json::array()}};
    for (const MethodRow& row : rows) json["methods"].push_back(rowJson(row));
    return jsonText(json, 2) + "\n";
}

}  // namespace demolish
