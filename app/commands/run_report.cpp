// JSON and table of one run.
#include "app/commands/run_report.h"

#include <tbb/global_control.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

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

}  // namespace

unsigned threadsInUse() {
    return static_cast<unsigned>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

std::string machineName() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);) {
        const auto colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

std::string reportJson(const BuiltShot& built, const RunReport& report) {
    const FrameStats& stats = built.solver->stats();
    Json json;
    json["scene"] = built.shot.scene;
    json["model"] = built.shot.model.filename().string();
    json["device"] = built.solver->deviceName();
    json["gl_renderer"] = report.gl_renderer;
    json["transfer"] = report.transfer;
    json["transfer_note"] = report.transfer_note;
    json["machine"] = machineName();
    json["threads"] = threadsInUse();
    json["version"] = DEMOLISH_VERSION;
    json["seed"] = built.shot.seed;
    json["material"] = built.shot.material_name;
    json["impact_velocity"] = built.shot.impact.velocity;
    json["width"] = report.width;
    json["height"] = report.height;
    json["frames"] = report.frames;
    json["wall_seconds"] = report.wall_seconds;
    json["build_seconds"] = built.build_seconds;
    json["fps_median"] = report.times.fps_median;
    json["fps_p1"] = report.times.fps_p1;
    json["fps_p99"] = report.times.fps_p99;
    json["frame_ms_p99"] = report.times.frame_ms_p99;
    json["sim_ms"] = report.times.sim_ms;
    json["draw_ms"] = report.times.draw_ms;
    json["draw_passes_ms"] = Json::object();
    for (const auto& [pass, ms] : report.draw_passes) json["draw_passes_ms"][pass] = ms;
    json["substeps_per_frame"] = stats.substeps;
    json["time_step"] = stats.time_step;
    json["time"] = stats.time;
    json["particles"] = stats.particles;
    json["particle_size"] = built.body->spacing;
    json["bonds"] = stats.bonds;
    json["bonds_broken"] = stats.bonds_broken;
    json["fragments"] = stats.fragments;
    json["largest_fragment_fraction"] = stats.largest_fragment_fraction;
    json["mass"] = stats.mass;
    json["mesh_volume"] = built.body->mesh_volume;
    json["cells_volume"] = built.body->cells_volume;
    json["open_cells"] = built.body->open_cells;
    json["linear_momentum"] = vectorJson(stats.linear_momentum);
    json["angular_momentum"] = vectorJson(stats.angular_momentum);
    json["energy"] = energyJson(report.energy.value_or(stats.energy));
    json["softening"] = softeningJson(built.solver->softening(), built.setup);
    json["state_hash"] = hexadecimal(built.solver->stateHash());
    json["status"] = describe(stats.status);
    return json.dump(2) + "\n";
}

std::string reportTable(const BuiltShot& built, const RunReport& report) {
    const FrameStats& stats = built.solver->stats();
    std::string table;
    addRow(table, "scene", built.shot.scene + " (" + built.shot.model.filename().string() + ")");
    addRow(table, "device", built.solver->deviceName());
    addRow(table, "drawn by",
           report.gl_renderer + (report.transfer == "none" ? "" : ", transfer: " + report.transfer));
    addRow(table, "frames", std::to_string(report.frames) + " in " + number(report.wall_seconds) + " s");
    addRow(table, "FPS median / p1 / p99",
           number(report.times.fps_median) + " / " + number(report.times.fps_p1) + " / " +
               number(report.times.fps_p99));
    addRow(table, "simulation",
           number(report.times.sim_ms, "%.3g") + " ms (" + std::to_string(stats.substeps) + " substeps)");
    addRow(table, "draw", number(report.times.draw_ms, "%.3g") + " ms");
    addRow(table, "particles",
           std::to_string(stats.particles) + " of " + number(1000 * built.body->spacing, "%.3g") + " mm");
    addRow(table, "in force", softeningText(built.solver->softening(), built.setup));
    addRow(table, "bonds", std::to_string(stats.bonds) + ", broken " + std::to_string(stats.bonds_broken));
    addRow(table, "fragments",
           std::to_string(stats.fragments) + ", largest " +
               number(100 * stats.largest_fragment_fraction, "%.1f %%") + " of the mass");
    addRow(table, "momentum", momentumText(stats));
    addRow(table, "state hash", hexadecimal(built.solver->stateHash()));
    addRow(table, "status", describe(stats.status));
    return table;
}

}  // namespace demolish
