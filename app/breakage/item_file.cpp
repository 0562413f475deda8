// SPDX-License-Identifier: Apache-2.0
// One JSON object an item; a row a specimen.
#include "app/breakage/item_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/session/json_text.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Energies are sums whose last bits depend on the device; four digits do not.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3e", value);
    return std::strtod(text, nullptr);
}

Json energyJson(const ItemResult& result) {
    const EnergyLedger& energy = result.energy;
    return {{"impact", rounded(result.impact_energy)}, {"kinetic", rounded(energy.kinetic)},
            {"elastic", rounded(energy.elastic)},      {"damping", rounded(energy.damping)},
            {"friction", rounded(energy.friction)},    {"fracture", rounded(energy.fracture)}};
}

ItemResult fromJson(const Json& json) {
    ItemResult result;
    json.at("time_step_s").get_to(result.time_step);
    json.at("substeps").get_to(result.substeps);
    json.at("particles").get_to(result.particles);
    json.at("bonds").get_to(result.bonds);
    json.at("bonds_broken").get_to(result.bonds_broken);
    const Json& energy = json.at("energy_j");
    energy.at("impact").get_to(result.impact_energy);
    energy.at("kinetic").get_to(result.energy.kinetic);
    energy.at("elastic").get_to(result.energy.elastic);
    energy.at("damping").get_to(result.energy.damping);
    energy.at("friction").get_to(result.energy.friction);
    energy.at("fracture").get_to(result.energy.fracture);
    for (const Json& row : json.at("specimens")) {
        Outcome outcome;
        row.at("largest").get_to(outcome.largest);
        row.at("children").get_to(outcome.children);
        row.at("split").get_to(outcome.split);
        row.at("meridional").get_to(outcome.meridional);
        result.outcomes.push_back(outcome);
    }
    return result;
}

}  // namespace

fs::path itemFile(const fs::path& folder, size_t item) {
    char name[32];
    std::snprintf(name, sizeof name, "item_%05zu.json", item);
    return folder / "items" / name;
}

std::string itemJson(const BreakagePlan& plan, size_t item, const std::vector<BreakageRun>& runs,
                     const ItemResult& result) {
    Json json{{"plan", plan.fingerprint()},
              {"item", item},
              {"experiment", plan.experiments[runs[0].experiment].name},
              {"time_step_s", result.time_step},
              {"substeps", result.substeps},
              {"particles", result.particles},
              {"bonds", result.bonds},
              {"bonds_broken", result.bonds_broken},
              {"energy_j", energyJson(result)},
              {"specimens", Json::array()}};
    for (size_t k = 0; k < runs.size(); ++k) {
        const Outcome& outcome = result.outcomes[k];
        json["specimens"].push_back(
            {{"diameter_m", plan.experiments[runs[k].experiment].diameters[runs[k].size]},
             {"velocity_mps", runs[k].velocity},
             {"packing", runs[k].packing},
             {"largest", outcome.largest},
             {"children", outcome.children},
             {"split", outcome.split},
             {"meridional", outcome.meridional}});
    }
    return jsonText(json, 1) + "\n";
}

void writeItem(const fs::path& folder, const BreakagePlan& plan, size_t item,
               const std::vector<BreakageRun>& runs, const ItemResult& result) {
    writeTextFile(itemFile(folder, item), itemJson(plan, item, runs, result));
}

std::optional<ItemResult> readItem(const fs::path& folder, const BreakagePlan& plan, size_t item,
                                   const std::vector<BreakageRun>& runs) {
    const fs::path file = itemFile(folder, item);
    if (!fs::exists(file)) return std::nullopt;
    try {
        const Json json = Json::parse(readTextFile(file));
        if (json.at("plan") == plan.fingerprint() && json.at("item") == item) {
            ItemResult result = fromJson(json);
            if (result.outcomes.size() == runs.size()) return result;
        }
    } catch (const Json::exception&) {
    }
    throw InputFileError(file.string() + " is not a result of this plan; remove it");
}

}  // namespace demolish
