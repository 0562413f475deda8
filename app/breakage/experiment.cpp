// SPDX-License-Identifier: Apache-2.0
// Files and records of experiments.
#include "app/breakage/experiment.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/session/data_folder.h"
#include "app/session/json_text.h"
#include "app/session/toml_reader.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kDefault = "breakage";
constexpr int kDeepest = 4;  ///< files that stand on each other by `like`

constexpr const char* kGrains[2] = {"same", "scaled"};
constexpr const char* kRules[3] = {"largest", "crack", "flaps"};

/// A value that stands for one of some words, by its place among them; false when it is none of them.
template <class Value, size_t kCount>
bool setByWord(const std::string& word, const char* const (&words)[kCount], Value& value) {
    const auto* found = std::find(std::begin(words), std::end(words), word);
    if (found == std::end(words)) return false;
    value = static_cast<Value>(found - std::begin(words));
    return true;
}

template <class Value, size_t kCount>
void readWord(TomlReader& reader, const char* key, const char* const (&words)[kCount], Value& value) {
    std::string word = words[static_cast<size_t>(value)], listed;
    reader.read(key, word);
    for (const char* one : words) listed += std::string(listed.empty() ? "" : ", ") + '"' + one + '"';
    if (!setByWord(word, words, value)) reader.fail(key, "must be one of " + listed);
}

/// "there/name.toml" beside `file`.
fs::path besides(const fs::path& file, const std::string& name) {
    return file.parent_path() / (name + ".toml");
}

BreakageExperiment loadOver(const fs::path& file, int depth) {
    TomlReader reader(file);
    std::string like;
    reader.read("like", like);
    if (!like.empty() && depth >= kDeepest) reader.fail("like", "leads through too many files");
    BreakageExperiment e = like.empty() ? BreakageExperiment{} : loadOver(besides(file, like), depth + 1);
    e.name = file.stem().string();
    e.title = e.name;
    reader.read("title", e.title);
    reader.read("why", e.why);
    visitValues(e, [&](const char* key, auto& value, const Range& range) { reader.read(key, value, range); });
    readWord(reader, "specimen.large_grains", kGrains, e.scaled_grains);
    readWord(reader, "broken.rule", kRules, e.rule);
    if (!(e.diameters[0] < e.diameters[1])) reader.fail("specimen", "must have small_m below large_m");
    if (e.slowest > e.fastest) reader.fail("impact", "must have slowest_mps below fastest_mps");
    reader.requireAllRead();
    return e;
}

}  // namespace

BreakageExperiment loadExperiment(const fs::path& file) {
    return loadOver(file, 0);
}

std::vector<std::string> experimentNames() {
    std::vector<std::string> names = assetNames("experiments");
    std::stable_partition(names.begin(), names.end(),
                          [](const std::string& name) { return name == kDefault; });
    return names;
}

BreakageExperiment findExperiment(const std::string& name_or_file) {
    if (fs::path(name_or_file).extension() == ".toml") return loadExperiment(name_or_file);
    const auto names = experimentNames();
    if (std::find(names.begin(), names.end(), name_or_file) == names.end()) {
        std::string listed;
        for (const auto& name : names) listed += (listed.empty() ? "" : ", ") + name;
        throw UsageError("there is no experiment '" + name_or_file + "'; choose one of: " + listed);
    }
    return loadExperiment(dataFolder() / "assets" / "experiments" / (name_or_file + ".toml"));
}

std::vector<double> velocitiesOf(const BreakageExperiment& e) {
    std::vector<double> velocities(e.velocities, e.slowest);
    for (uint32_t k = 1; k < e.velocities; ++k)
        velocities[k] = e.slowest + (e.fastest - e.slowest) * k / (e.velocities - 1);
    return velocities;
}

SphereSpecimen specimenOf(const BreakageExperiment& e, uint32_t size, uint32_t packing) {
    SphereSpecimen specimen;
    specimen.diameter = e.diameters[size];
    specimen.grains = e.grains;
    if (size == 1 && !e.scaled_grains)
        specimen.grains =
            static_cast<uint32_t>(std::lround(e.grains * std::pow(e.diameters[1] / e.diameters[0], 3)));
    specimen.solid_fraction = e.solid_fraction;
    specimen.radius_scatter = e.radius_scatter;
    specimen.bond_gap = e.bond_gap;
    specimen.bond_ratio = e.bond_ratio;
    specimen.seed = (uint64_t{e.seed} << 32) + 2 * packing + size;
    return specimen;
}

Material materialOf(const BreakageExperiment& e, uint32_t size) {
    Material material;
    material.name = e.name;
    material.density = e.density;
    material.youngs_modulus = e.youngs_modulus;
    material.poisson_ratio = e.poisson_ratio;
    material.friction = e.friction;
    material.restitution = e.restitution;
    material.rolling_friction = 0;
    material.damping_ratio = e.damping_ratio;
    material.tough_cells = 0;
    material.bond_law = BondLaw::kSpheres;
    material.bond_ratio = e.bond_ratio;
    material.fracture_energy = e.fracture_energy * (size == 1 ? e.large_energy_factor : 1);
    return material;
}

std::string experimentJson(const BreakageExperiment& experiment) {
    Json json{{"name", experiment.name},
              {"title", experiment.title},
              {"why", experiment.why},
              {"specimen.large_grains", kGrains[experiment.scaled_grains ? 1 : 0]},
              {"broken.rule", kRules[static_cast<size_t>(experiment.rule)]}};
    visitValues(experiment, [&](const char* key, auto value, const Range&) { json[key] = value; });
    return jsonText(json, -1);
}

BreakageExperiment experimentFromJson(const std::string& text) {
    try {
        const Json json = Json::parse(text);
        BreakageExperiment e;
        e.name = json.at("name").get<std::string>();
        e.title = json.at("title").get<std::string>();
        e.why = json.at("why").get<std::string>();
        const auto word = [&](const char* key) { return json.at(key).get<std::string>(); };
        if (!setByWord(word("specimen.large_grains"), kGrains, e.scaled_grains) ||
            !setByWord(word("broken.rule"), kRules, e.rule))
            throw InputFileError("this is no record of an experiment: it has a word that is unknown");
        visitValues(e, [&](const char* key, auto& value, const Range&) { json.at(key).get_to(value); });
        return e;
    } catch (const Json::exception& error) {
        throw InputFileError(std::string("this is no record of an experiment: ") + error.what());
    }
}

}  // namespace demolish
