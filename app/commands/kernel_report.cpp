// SPDX-License-Identifier: Apache-2.0
// Table, JSON and CSV of the substep's times.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/kernel_bench.h"
#include "app/commands/text_table.h"
#include "app/session/json_text.h"

namespace demolish {
namespace {

/// "55 %"; "-" where there is no floor.
std::string shareOf(double floor_us, double us) {
    return floor_us > 0 && us > 0 ? formatted("%.0f %%", 100 * floor_us / us) : "-";
}

const FloorScheme* bestScheme(const SubstepFloor& floor) {
    const auto best = std::min_element(
        floor.schemes.begin(), floor.schemes.end(),
        [](const FloorScheme& a, const FloorScheme& b) { return a.microseconds < b.microseconds; });
    return best != floor.schemes.end() ? &*best : nullptr;
}

std::string lineOf(const KernelRow& row) {
    const std::string bonds_floor = row.floor.bonds_us > 0 ? formatted("%.2f", row.floor.bonds_us) : "-";
    return formatted("  %9u %9u %10.2f %9s %6s %9.2f %6s %11.2f %9u %10.2f\n", row.particles, row.bonds,
                     row.intact_us, bonds_floor.c_str(), shareOf(row.floor.bonds_us, row.intact_us).c_str(),
                     row.floor.memory_us, shareOf(row.floor.memory_us, row.intact_us).c_str(),
                     row.shattering_us, row.shattering_broken, row.broken_us);
}

}  // namespace

std::string kernelTable(std::span<const KernelRow> rows, const KernelPlace& place) {
    std::string table = "  Substep of a block of stone, us, on " + place.device + " (" + place.machine +
                        ", " + std::to_string(place.threads) + " threads, driver: " + place.driver + ")\n\n";
    table += formatted("  %9s %9s %10s %9s %6s %9s %6s %11s %9s %10s\n", "", "", "", "floor:", "",
                       "floor:", "", "", "bonds", "all");
    table += formatted("  %9s %9s %10s %9s %6s %9s %6s %11s %9s %10s\n", "particles", "bonds", "intact",
                       "bonds", "share", "memory", "share", "shattering", "broken", "broken");
    for (const auto& row : rows) table += lineOf(row);
    table += '\n';
    for (const auto& row : rows) {
        if (const FloorScheme* best = bestScheme(row.floor))
            table += formatted("  floor of bonds at %u: %s\n", row.particles, best->name.c_str());
        if (row.broken_broken < row.bonds)
            table += formatted("  at %u only %u bonds broke in the block that should fall apart\n",
                               row.particles, row.broken_broken);
    }
    if (!rows.empty())
        table += formatted("  floor of memory: %.0f GB/s, read and written together, by a large copy\n",
                           1e-9 * rows.front().floor.copy_bandwidth);
    return table;
}

std::string kernelJson(std::span<const KernelRow> rows, const KernelPlace& place) {
    using Json = nlohmann::ordered_json;
    Json json = {{"device", place.device},   {"driver", place.driver},   {"machine", place.machine},
                 {"threads", place.threads}, {"version", place.version}, {"rows", Json::array()}};
    for (const auto& row : rows) {
        Json schemes = Json::object();
        for (const auto& scheme : row.floor.schemes) schemes[scheme.name] = scheme.microseconds;
        json["rows"].push_back(
            {{"particles", row.particles},
             {"bonds", row.bonds},
             {"intact_us", row.intact_us},
             {"shattering_us", row.shattering_us},
             {"shattering_broken", row.shattering_broken},
             {"broken_us", row.broken_us},
             {"broken_broken", row.broken_broken},
             {"floor_bytes", row.floor.bytes},
             {"floor_copy_bandwidth", row.floor.copy_bandwidth},
             {"floor_memory_us", row.floor.memory_us},
             {"floor_bonds_us", row.floor.bonds_us > 0 ? Json(row.floor.bonds_us) : Json()},
             {"floor_schemes_us", schemes}});
    }
    return jsonText(json, 2) + "\n";
}

std::string kernelCsv(std::span<const KernelRow> rows, const KernelPlace& place) {
    std::string text =
        csvLine({"device", "driver", "machine", "threads", "version", "particles", "bonds", "intact_us",
                 "shattering_us", "shattering_broken", "broken_us", "broken_broken", "floor_bonds_us",
                 "floor_scheme", "floor_memory_us", "copy_bandwidth"});
    for (const auto& row : rows) {
        const FloorScheme* best = bestScheme(row.floor);
        text += csvLine(
            {place.device, place.driver, place.machine, std::to_string(place.threads), place.version,
             std::to_string(row.particles), std::to_string(row.bonds), formatted("%.6g", row.intact_us),
             formatted("%.6g", row.shattering_us), std::to_string(row.shattering_broken),
             formatted("%.6g", row.broken_us), std::to_string(row.broken_broken),
             best != nullptr ? formatted("%.6g", best->microseconds) : "", best != nullptr ? best->name : "",
             formatted("%.6g", row.floor.memory_us), formatted("%.6g", row.floor.copy_bandwidth)});
    }
    return text;
}

}  // namespace demolish
