// SPDX-License-Identifier: Apache-2.0
// JSON and table of one run.
#include "app/commands/run_report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/build_version.h"
#include "app/commands/machine_facts.h"
#include "app/commands/phase_report.h"
#include "app/commands/run_formats.h"
#include "app/commands/text_table.h"
#include "app/commands/threshold_json.h"
#include "app/session/json_text.h"
#include "app/session/shot_bodies.h"

namespace demolish {
namespace {

using Json = nlohmann::ordered_json;

std::string hexadecimal(uint64_t value) {
    char text[32];
    std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(value));
    return text;
}

Json vectorJson(const Double3& v) {
    return Json::array({v.x, v.y, v.z});
}

Json energyJson(const EnergyLedger& energy) {
    return {{"kinetic", energy.kinetic},  {"elastic", energy.elastic},   {"potential", energy.potential},
            {"damping", energy.damping},  {"friction", energy.friction}, {"fracture", energy.fracture},
            {"external", energy.external}};
}

Json balanceJson(const EnergyBalance& balance) {
    Json json = energyJson(balance.now);
    json["initial"] = {{"kinetic", balance.start.kinetic},
                       {"elastic", balance.start.elastic},
                       {"potential", balance.start.potential}};
    json["brought_in"] = balance.broughtIn();
    json["closure"] = balance.closure();
    return json;
}

Json softeningJson(const SofteningReport& softening, const SceneSetup& setup) {
    return {{"in_force", setup.params.soften},
            {"bond_modulus", softening.bond_modulus},
            {"effective_modulus", softening.effective_modulus},
            {"real_modulus", setup.bodies[0].material.youngs_modulus},
            {"wave_speed", softening.wave_speed},
            {"strength", softening.strength},
            {"real_strength", setup.bodies[0].material.tensile_strength},
            {"strain_at_failure", softening.strain_at_failure},
            {"highest_frequency", softening.highest_frequency}};
}

void addRow(std::string& table, const char* label, const std::string& value) {
    char line[256];
    std::snprintf(line, sizeof line, "  %-22s %s\n", label, value.c_str());
    table += line;
}

std::string number(double value, const char* format = "%.1f") {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string momentumText(const FrameStats& stats) {
    const Double3& p = stats.linear_momentum;
    return number(p.x, "%.3g") + ", " + number(p.y, "%.3g") + ", " + number(p.z, "%.3g") + " kg m/s";
}

std::string softeningText(const SofteningReport& softening, const SceneSetup& setup) {
    const Material& material = setup.bodies[0].material;
    return "E " + number(softening.effective_modulus / 1e6, "%.3g") + " MPa of " +
           number(material.youngs_modulus / 1e9, "%.3g") + " GPa, breaks at " +
           number(softening.strength / 1e6, "%.3g") + " MPa of " +
           number(material.tensile_strength / 1e6, "%.3g") + " MPa, strain " +
           number(100 * softening.strain_at_failure, "%.2f %%");
}

/// Bodies that are made alike, in the order of the first of each.
Json kindsJson(const BuiltShot& built) {
    const std::vector<SceneBody> bodies = bodiesOf(built.shot);
    const std::vector<size_t> alike = firstAlike(bodies);
    Json kinds = Json::array();
    for (size_t b = 0; b < bodies.size(); ++b) {
        if (alike[b] != b) continue;
        const Shot of = asOf(built.shot, bodies[b]);
        const BreakableBody& body = *built.cells.of_body[b];
        Json names = Json::array();
        for (size_t i = 0; i < bodies.size(); ++i)
            if (alike[i] == b && !bodies[i].name.empty()) names.push_back(bodies[i].name);
        kinds.push_back({{"names", names},
                         {"model", of.model.filename().string()},
                         {"material", of.material_name},
                         {"bodies", std::count(alike.begin(), alike.end(), b)},
                         {"particles", body.particles.size()},
                         {"particle_size", body.spacing},
                         {"mesh_volume", body.mesh_volume},
                         {"cells_volume", body.cells_volume}});
    }
    return kinds;
}

/// What was run, and where.
void addRun(const BuiltShot& built, const RunReport& report, Json& json) {
    json["scene"] = built.shot.scene;
    json["model"] = built.shot.model.filename().string();
    json["mode"] = report.mode;
    json["device"] = built.solver->deviceName();
    json["driver"] = gpuDriver();
    json["gl_renderer"] = report.gl_renderer;
    json["gl_version"] = report.gl_version;
    json["quality"] = report.quality;
    json["transfer"] = report.transfer;
    json["transfer_note"] = report.transfer_note;
    json["machine"] = machineName();
    json["threads"] = threadsInUse();
    json["version"] = buildVersion();
    json["seed"] = built.shot.seed;
    json["material"] = built.shot.material_name;
    json["method"] = methodName(built.shot.method);
    if (const auto& preset = built.setup.params.preset_pieces) json["pattern"] = patternName(preset->pattern);
    json["impact_velocity"] = built.shot.impact.velocity;
    json["threshold"] = thresholdJson(built.shot, *built.body);
    json["width"] = report.width;
    json["height"] = report.height;
    json["bodies"] = built.setup.bodies.size();
    json["body_kinds"] = kindsJson(built);
    json["fps"] = built.shot.fps;
    json["time_scale"] = built.shot.time_scale;
    json["frame_seconds"] = report.frame_seconds;
}

void addTimes(const BuiltShot& built, const RunReport& report, Json& json) {
    json["frames"] = report.frames;
    json["wall_seconds"] = report.wall_seconds;
    json["build_seconds"] = built.build_seconds;
    json["fps_median"] = report.times.fps_median;
    json["fps_p1"] = report.times.fps_p1;
    json["fps_p99"] = report.times.fps_p99;
    json["frame_ms_p99"] = report.times.frame_ms_p99;
    json["frame_ms_worst"] = report.times.frame_ms_worst;
    json["sim_ms"] = report.times.sim_ms;
    json["transfer_ms"] = report.times.transfer_ms;
    json["draw_ms"] = report.times.draw_ms;
    json["draw_passes_ms"] = Json::object();
    for (const auto& [pass, ms] : report.draw_passes) json["draw_passes_ms"][pass] = ms;
    json["phases"] = phaseJson(report.phases, built.setup.bodies.size());
}

/// What has become of the bodies.
void addState(const BuiltShot& built, const RunReport& report, Json& json) {
    const FrameStats& stats = built.solver->stats();
    json["substeps_per_frame"] = stats.substeps;
    json["time_step"] = stats.time_step;
    json["time"] = stats.time;
    json["particles"] = stats.particles;
    json["particle_size"] = built.body->spacing;
    json["bonds"] = stats.bonds;
    json["bonds_broken"] = stats.bonds_broken;
    json["bonds_parted"] = stats.bonds_parted;
    json["max_stress_ratio"] = stats.max_stress_ratio;
    json["fragments"] = stats.fragments;
    json["largest_fragment_fraction"] = stats.largest_fragment_fraction;
    json["mass"] = stats.mass;
    json["mesh_volume"] = built.body->mesh_volume;
    json["cells_volume"] = built.body->cells_volume;
    json["open_cells"] = built.body->open_cells;
    json["repair"] = repairLines(repairReport(*built.cells.subject_mesh));
    if (built.body->remeshed) json["repair"].push_back("cells cut within a new surface");
    if (const ModelLooks* looks = modelLooks(*built.cells.subject_mesh)) json["looks_notes"] = looks->notes;
    json["linear_momentum"] = vectorJson(stats.linear_momentum);
    json["angular_momentum"] = vectorJson(stats.angular_momentum);
    if (report.energy) json["energy"] = balanceJson(*report.energy);
    json["softening"] = softeningJson(built.solver->softening(), built.setup);
    json["state_hash"] = hexadecimal(built.solver->stateHash());
    json["status"] = describe(stats.status);
}

}  // namespace

std::string reportJson(FinishedRun& run) {
    if (run.energy) run.report.energy = run.energy();
    const BuiltShot& built = run.built;
    const RunReport& report = run.report;
    Json json;
    addRun(built, report, json);
    addTimes(built, report, json);
    addState(built, report, json);
    return jsonText(json, 2) + "\n";
}

std::vector<std::pair<std::string, std::string>> runFacts(const BuiltShot& built, const RunReport& report) {
    return {{"scene", built.shot.scene},
            {"model", modelName(built.shot.model)},
            {"mode", report.mode},
            {"method", methodName(built.shot.method)},
            {"device", built.solver->deviceName()},
            {"driver", gpuDriver()},
            {"machine", machineName()},
            {"threads", std::to_string(threadsInUse())},
            {"gl_renderer", report.gl_renderer},
            {"width", std::to_string(report.width)},
            {"height", std::to_string(report.height)},
            {"quality", report.quality},
            {"transfer", report.transfer},
            {"version", buildVersion()},
            {"seed", std::to_string(built.shot.seed)},
            {"frame_seconds", number(report.frame_seconds, "%.9g")}};
}

namespace {

std::string drawnBy(const RunReport& report) {
    if (report.width == 0) return "nothing is drawn";
    return report.gl_renderer + ", " + std::to_string(report.width) + "x" + std::to_string(report.height) +
           ", " + report.quality + ", transfer: " + report.transfer;
}

void addTimes(std::string& table, const FrameSummary& times, uint32_t substeps) {
    addRow(table, "FPS median / p1 / p99",
           number(times.fps_median) + " / " + number(times.fps_p1) + " / " + number(times.fps_p99));
    const std::string done = std::to_string(substeps);
    addRow(table, "simulation", number(times.sim_ms, "%.3g") + " ms (" + done + " substeps)");
    addRow(table, "draw", number(times.draw_ms, "%.3g") + " ms");
}

}  // namespace

std::string reportTable(const BuiltShot& built, const RunReport& report) {
    const FrameStats& stats = built.solver->stats();
    const size_t bodies = built.setup.bodies.size();
    std::string table;
    addRow(table, "scene", built.shot.scene + " (" + modelName(built.shot.model) + ")");
    addRow(table, "machine", machineName() + ", " + std::to_string(threadsInUse()) + " threads");
    addRow(table, "device", built.solver->deviceName() + ", driver: " + gpuDriver());
    addRow(table, "drawn by", drawnBy(report));
    addRow(table, "frames", std::to_string(report.frames) + " in " + number(report.wall_seconds) + " s");
    if (report.frame_seconds > 0)
        addRow(table, "simulated a frame", number(1000 * report.frame_seconds, "%.4f") + " ms, none less");
    if (report.phases.empty()) addTimes(table, report.times, stats.substeps);
    addRow(table, "particles",
           std::to_string(stats.particles) + " of " + number(1000 * built.body->spacing, "%.3g") + " mm in " +
               std::to_string(bodies) + (bodies == 1 ? " body" : " bodies"));
    addRow(table, "in force", softeningText(built.solver->softening(), built.setup));
    if (const auto threshold = thresholdOf(built.shot, *built.body))
        addRow(table, "breaks from",
               number(threshold->velocity(), "%.3g") + " m/s (" + threshold->source() + ")");
    addRow(table, "bonds",
           std::to_string(stats.bonds) + ", broken " + std::to_string(stats.bonds_broken) +
               ", of these parted " + std::to_string(stats.bonds_parted));
    addRow(table, "fragments",
           std::to_string(stats.fragments) + ", largest " +
               number(100 * stats.largest_fragment_fraction, "%.1f %%") + " of the mass");
    addRow(table, "momentum", momentumText(stats));
    if (report.energy)
        addRow(table, "energy found again",
               number(report.energy->closure(), "%.4f") + " of " +
                   number(report.energy->broughtIn(), "%.4g") + " J brought in");
    addRow(table, "state hash", hexadecimal(built.solver->stateHash()));
    addRow(table, "status", describe(stats.status));
    if (report.phases.empty()) return table;
    table += '\n';
    table += phaseTable(report.phases, bodies);
    return table;
}

std::string phasesCsv(FinishedRun& run) {
    return phaseCsv(run.report.phases, run.built.setup.bodies.size(), runFacts(run.built, run.report));
}

}  // namespace demolish
