// SPDX-License-Identifier: Apache-2.0
// Plans as JSON; a fingerprint that results carry.
#include "app/breakage/plan.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/session/json_text.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

fs::path planFile(const fs::path& folder) {
    return folder / "plan.json";
}

}  // namespace

std::vector<std::vector<BreakageRun>> BreakagePlan::items() const {
    std::vector<std::vector<BreakageRun>> all;
    for (uint32_t k = 0; k < experiments.size(); ++k) {
        const auto velocities = velocitiesOf(experiments[k]);
        uint32_t room = 0;
        for (uint32_t size = 0; size < 2; ++size)
            for (uint32_t speed = 0; speed < velocities.size(); ++speed)
                for (uint32_t packing = 0; packing < experiments[k].packings; ++packing) {
                    if (room == 0) {
                        all.emplace_back();
                        room = batch;
                    }
                    all.back().push_back({k, size, packing, speed, velocities[speed]});
                    --room;
                }
    }
    return all;
}

std::string BreakagePlan::json() const {
    Json json{{"batch", batch}, {"experiments", Json::array()}};
    for (const auto& experiment : experiments)
        json["experiments"].push_back(Json::parse(experimentJson(experiment)));
    return jsonText(json, 1) + "\n";
}

std::string BreakagePlan::fingerprint() const {
    uint64_t hash = 0xcbf29ce484222325ull;  // FNV-1a
    for (const char c : json()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

void settlePlan(const BreakagePlan& plan, const fs::path& folder) {
    makeOutputFolder(folder);
    makeOutputFolder(folder / "items");
    if (!fs::exists(planFile(folder))) return writeTextFile(planFile(folder), plan.json());
    if (readTextFile(planFile(folder)) != plan.json())
        throw UsageError(folder.string() +
                         " holds results of other settings; choose another --out, or remove that folder");
}

BreakagePlan readPlan(const fs::path& folder) {
    const std::string text = readTextFile(planFile(folder));
    try {
        const Json json = Json::parse(text);
        BreakagePlan plan;
        plan.batch = json.at("batch").get<uint32_t>();
        for (const auto& experiment : json.at("experiments"))
            plan.experiments.push_back(experimentFromJson(jsonText(experiment, -1)));
        if (plan.batch > 0 && !plan.experiments.empty()) return plan;
    } catch (const Json::exception&) {
    }
    throw InputFileError(planFile(folder).string() + " is not a plan of demolish breakage");
}

std::string readTextFile(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw InputFileError(file.string() + " cannot be read; run demolish breakage --out first");
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace demolish
