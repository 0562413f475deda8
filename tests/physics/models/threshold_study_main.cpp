// SPDX-License-Identifier: Apache-2.0
// threshold_study: the whole study or a part of it, a CSV row a body, kind of impact and particle size.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "sim_cuda/api/errors.h"
#include "tests/physics/models/threshold_study.h"

namespace demolish::tests {
namespace {

struct StudyOptions {
    std::string series = "bodies", device = "cpu", folder = "/tmp";
    std::vector<std::string> bodies, kinds{"drop", "ball"};
    std::vector<uint32_t> particles{1000, 3000, 10000};
    std::vector<double> tough_factors{1, 2, 3, 4};
    uint32_t packings = 4, first_packing = 0, finer_steps = 1;
    double tolerance = 0.06;
};

bool among(const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// m/s, of each packing, parted by semicolons.
std::string packingsOf(const StudyResult& result) {
    std::string text;
    for (const Bracket& bracket : result.threshold.packings) {
        if (!text.empty()) text += ';';
        text += std::to_string(bracket.threshold());
    }
    return text;
}

void printRow(const StudyShot& shot, const StudyCase& wanted, const StudyResult& result, double seconds) {
    const Material& material = shot.shot.material;
    std::printf("%s,%s,%u,%.2f,%u,%.2f,%.2f,%.3f,%.3f,%u,%u,%.4f,%.4f,%.3f,%.4f,%.4f,%.1f,%s\n",
                shot.body.c_str(), shot.kind.c_str(), wanted.particles, result.size_ratio,
                material.tough_cells, material.tough_factor, material.beta, material.critical_velocity,
                material.damping_ratio, result.substeps, wanted.trial.finer_steps, result.threshold.velocity,
                result.threshold.share, result.spread(), result.body_mass, result.ball_mass, seconds,
                packingsOf(result).c_str());
    std::fflush(stdout);
}

void runStudy(const StudyOptions& options) {
    std::vector<StudyShot> shots;
    if (options.series == "beta")
        for (const double factor : options.tough_factors) shots.push_back(sphereDrop(options.folder, factor));
    else
        for (StudyShot& shot : studyShots(options.folder))
            if (among(options.bodies, shot.body) && among(options.kinds, shot.kind))
                shots.push_back(std::move(shot));
    std::puts(
        "body,kind,particles,size_ratio,cells,tough_factor,beta,critical_velocity,damping,substeps,"
        "finer_steps,threshold,share,spread,body_mass,ball_mass,seconds,packings");
    for (const StudyShot& shot : shots)
        for (const uint32_t particles : options.particles) {
            const auto begun = std::chrono::steady_clock::now();
            StudyCase wanted{
                &shot, particles, options.packings, options.tolerance, {}, options.first_packing};
            wanted.trial = {options.device == "cuda", options.finer_steps};
            try {
                const StudyResult result = runCase(wanted);
                printRow(shot, wanted, result,
                         std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
            } catch (const Error& error) {
                std::fprintf(stderr, "%s %s %u: %s\n", shot.body.c_str(), shot.kind.c_str(), particles,
                             error.what());
            }
        }
}

}  // namespace
}  // namespace demolish::tests

int main(int argument_count, char** arguments) {
    demolish::tests::StudyOptions options;
    CLI::App app{"Thresholds over particle size", "threshold_study"};
    app.add_option("--series", options.series, "bodies, or beta: the sphere with and without tough cells")
        ->check(CLI::IsMember({"bodies", "beta"}));
    app.add_option("--bodies", options.bodies)->delimiter(',');
    app.add_option("--kinds", options.kinds)->delimiter(',');
    app.add_option("--particles", options.particles)->delimiter(',');
    app.add_option("--tough-factors", options.tough_factors, "1: no tough cells")->delimiter(',');
    app.add_option("--packings", options.packings);
    app.add_option("--first-packing", options.first_packing,
                   "which to begin with, so that processes can share");
    app.add_option("--finer-steps", options.finer_steps, "substeps at the same stiffness, that many times");
    app.add_option("--tolerance", options.tolerance);
    app.add_option("--device", options.device)->check(CLI::IsMember({"cpu", "cuda"}));
    app.add_option("--folder", options.folder, "where the sphere's mesh goes");
    CLI11_PARSE(app, argument_count, arguments);
    try {
        demolish::tests::runStudy(options);
    } catch (const demolish::Error& error) {
        std::fprintf(stderr, "threshold_study: %s\n", error.what());
        return static_cast<int>(error.code());
    }
    return 0;
}
