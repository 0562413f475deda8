// SPDX-License-Identifier: Apache-2.0
// Search with a progress bar, a few lines and JSON.
#include "app/commands/calibrate_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/calibrate/calibration.h"
#include "app/commands/help_text.h"
#include "app/commands/progress_bar.h"
#include "app/commands/text_table.h"
#include "app/session/json_text.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kPackingsRange{1, 100}, kToleranceRange{0.005, 1};

const char* impactName(const Shot& shot) {
    return shot.impact.kind == ImpactKind::kDrop ? "drop" : "ball";
}

/// m/s, half a bracket to either side.
std::pair<double, double> ends(const Calibration& found) {
    const double half = std::sqrt(1 + found.measured.tolerance);
    return {found.velocity() / half, found.velocity() * half};
}

std::string calibrationJson(const Calibration& found) {
    const auto [low, high] = ends(found);
    const double critical = found.shot.material.critical_velocity;
    nlohmann::ordered_json json{{"scene", found.shot.scene},
                                {"model", found.shot.model.filename().string()},
                                {"impact", impactName(found.shot)},
                                {"material", found.shot.material_name},
                                {"particles", found.particles},
                                {"particle_size", found.particle_size},
                                {"seed", found.shot.seed},
                                {"critical_velocity", critical},
                                {"threshold", found.velocity()},
                                {"bracket", {low, high}},
                                {"packings", found.measured.packings},
                                {"lowest", found.measured.lowest * critical},
                                {"highest", found.measured.highest * critical},
                                {"tolerance", found.measured.tolerance},
                                {"predicted", found.threshold.predicted},
                                {"predicted_scatter", found.threshold.scatter},
                                {"predicted_from", found.threshold.is_known_body ? "body" : "rule"},
                                {"ratio", found.velocity() / found.threshold.predicted},
                                {"trials", found.trials},
                                {"from_cache", found.from_cache}};
    json["break_at"] = nullptr;
    if (found.shot.break_at) json["break_at"] = *found.shot.break_at;
    json["break_at_met"] = nullptr;
    if (found.shot.break_at) json["break_at_met"] = found.meetsBreakAt();
    return jsonText(json, 2) + "\n";
}

void printFound(const Calibration& found) {
    const auto [low, high] = ends(found);
    const double critical = found.shot.material.critical_velocity;
    std::printf("  %-12s %s (%s), %s; %u particles of %.3g mm, critical velocity %.3g m/s\n", "shot",
                found.shot.scene.c_str(), modelName(found.shot.model).c_str(), impactName(found.shot),
                found.particles, 1000 * found.particle_size, critical);
    if (found.shot.break_at)
        std::printf("  %-12s %.3g m/s%s\n", "to break at", *found.shot.break_at,
                    found.meetsBreakAt()
                        ? ""
                        : "; no strength does it within 10 %, this is the nearest: at some "
                          "speeds above its threshold this packing holds, try another --seed");
    std::printf("  %-12s %.3g m/s, between %.3g and %.3g", "threshold", found.velocity(), low, high);
    if (found.measured.packings > 1)
        std::printf("; mean of %u packings, %.3g to %.3g", found.measured.packings,
                    found.measured.lowest * critical, found.measured.highest * critical);
    if (found.from_cache)
        std::puts("; from the cache");
    else
        std::printf("; %u trials\n", found.trials);
    std::printf("  %-12s %.3g m/s, within a factor of %.2f (%s)\n", "table", found.threshold.predicted,
                found.threshold.scatter,
                found.threshold.is_known_body ? "this body" : "rule from shape and mass");
    std::printf("  %-12s %.2f\n", "measured/table", found.velocity() / found.threshold.predicted);
}

void runCalibrate(const CalibrateOptions& options) {
    requireInRange("--packings", options.packings, kPackingsRange, "");
    if (options.packings != std::floor(options.packings))
        throw UsageError("--packings must be a whole number");
    requireInRange("--tolerance", options.tolerance, kToleranceRange, "");
    if (!options.json.empty()) requireWritable(options.json);
    const Shot shot = makeShot(options.shot);
    if (shot.impact.kind == ImpactKind::kNone)
        throw UsageError("nothing hits the body of this scene; drop it with --drop");
    CalibrationOptions wanted;
    wanted.packings = static_cast<uint32_t>(options.packings);
    wanted.tolerance = options.tolerance;
    wanted.use_cache = !options.no_cache;
    wanted.on_gpu = choosesCuda(shot);
    ProgressBar bar;
    const Calibration found = calibrate(shot, nullptr, wanted, [&](double fraction, const char* stage) {
        bar.show(fraction, stage);
        return true;
    });
    bar.finish();
    printFound(found);
    if (!options.json.empty()) writeTextFile(options.json, calibrationJson(found));
}

}  // namespace

void addCalibrateCommand(CLI::App& app, CalibrateOptions& options) {
    auto* command = app.add_subcommand("calibrate", "Find the velocity from which a shot breaks its body");
    addShotOptions(*command, options.shot);
    command->add_option("--packings", options.packings, "Mean over this many random packings")
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--tolerance", options.tolerance, "Width of the bracket, as a share")
        ->type_name("SHARE")
        ->capture_default_str();
    command->add_option("--json", options.json, "Write the result here")->type_name("FILE");
    command->add_flag("--no-cache", options.no_cache,
                      "Measure even what was measured before, and keep nothing");
    setExamples(*command, {"calibrate bunny --packings 4", "calibrate vase --drop 1 --break-at 3"});
    command->callback([&options] { runCalibrate(options); });
}

}  // namespace demolish
