// SPDX-License-Identifier: Apache-2.0
// Fixed formats, so that equal results are equal bytes.
#include "app/breakage/report.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/breakage/figures.h"
#include "app/breakage/png_figure.h"
#include "app/session/json_text.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

template <class... Values>
std::string line(const char* pattern, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

/// null for a number that is none.
Json orNull(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double micrometres(const BreakageExperiment& experiment, uint32_t size) {
    return experiment.diameters[size] * 1e6;
}

Json cellJson(const BreakageExperiment& experiment, double velocity, const BreakageCell& cell) {
    const Interval wilson = wilsonInterval(cell.broken, cell.specimens);
    return {{"velocity_mps", velocity},
            {"specimens", cell.specimens},
            {"broken", cell.broken},
            {"probability", cell.probability()},
            {"wilson_95", {wilson.low, wilson.high}},
            {"broken_by_largest", cell.split},
            {"broken_by_meridional_crack", cell.meridional},
            {"both_rules", cell.both},
            {"rules_agree", cell.agreement()},
            {"mean_children", cell.broken > 0 ? Json(cell.meanChildren()) : Json(nullptr)},
            {"children", Json(std::vector<uint32_t>(cell.children.begin(), cell.children.end()))},
            {"child_share", experiment.criteria.child_share}};
}

Json readingJson(const BreakageExperiment& experiment, const BreakageStatistics& statistics) {
    Json json{{"settings", Json::parse(experimentJson(experiment))},
              {"time_step_s", statistics.time_step},
              {"substeps", statistics.substeps},
              {"particles", statistics.particles},
              {"energy_over_impact",
               {{"kinetic", statistics.kinetic},
                {"damping", statistics.damping},
                {"friction", statistics.friction},
                {"fracture", statistics.fracture},
                {"sum", statistics.sum}}}};
    json["sizes"] = Json::array();
    for (uint32_t size = 0; size < 2; ++size) {
        Json cells = Json::array();
        for (size_t k = 0; k < statistics.velocities.size(); ++k)
            cells.push_back(cellJson(experiment, statistics.velocities[k], statistics.cells[size][k]));
        json["sizes"].push_back({{"diameter_m", experiment.diameters[size]},
                                 {"velocity_of_half", orNull(velocityAt(statistics, size, 0.5))},
                                 {"share_of_3_to_5_children", shareOfThreeToFive(statistics, size)},
                                 {"sweep", cells}});
    }
    json["stated_in_the_paper"] = Json::array();
    for (const StatedPoint& point : kStated)
        json["stated_in_the_paper"].push_back(
            {{"diameter_m", point.size == 0 ? 24e-6 : 36e-6},
             {"velocity_mps", point.velocity},
             {"stated", point.probability},
             {"measured", probabilityAt(statistics, point.size, point.velocity)},
             {"in_3_to_5_children", countedAt(statistics, point.size, point.velocity)}});
    json["distance_to_the_paper"] = distanceToPaper(statistics);
    json["distance_with_figure_2_counted_in_3_to_5_children"] = distanceCounted(statistics);
    return json;
}

std::string cellText(const BreakageCell& cell) {
    const Interval wilson = wilsonInterval(cell.broken, cell.specimens);
    return line("%3u of %-3u  %.2f [%.2f %.2f]  %3u    %3.0f %%  %4.1f", cell.broken, cell.specimens,
                cell.probability(), wilson.low, wilson.high, cell.meridional, 100 * cell.agreement(),
                cell.meanChildren());
}

std::string readingTable(const BreakageExperiment& experiment, const BreakageStatistics& statistics) {
    std::string text = experiment.name + ": " + experiment.title + "\n";
    for (uint32_t size = 0; size < 2; ++size) {
        text += line("  %g um         broken      P    95 %% Wilson  crack  agree  children\n",
                     micrometres(experiment, size));
        for (size_t k = 0; k < statistics.velocities.size(); ++k)
            text +=
                line("  %6.2f m/s  ", statistics.velocities[k]) + cellText(statistics.cells[size][k]) + "\n";
        const double half = velocityAt(statistics, size, 0.5);
        text += line("  P = 0.5 at %s, 3 to 5 children in %.0f %% of the broken\n",
                     std::isfinite(half) ? line("%.1f m/s", half).c_str() : "no velocity of the sweep",
                     100 * shareOfThreeToFive(statistics, size));
    }
    text += line(
        "  energy after impact: kinetic %.2f, damping %.2f, friction %.2f, fracture %.2f, sum %.3f\n",
        statistics.kinetic, statistics.damping, statistics.friction, statistics.fracture, statistics.sum);
    for (const StatedPoint& point : kStated)
        text += line("  paper, %g um at %g m/s: %.2f, here %.2f, in 3 to 5 children %.2f\n",
                     point.size == 0 ? 24.0 : 36.0, point.velocity, point.probability,
                     probabilityAt(statistics, point.size, point.velocity),
                     countedAt(statistics, point.size, point.velocity));
    return text + line("  distance to these four: %.2f; with 43 m/s counted in 3 to 5 children: %.2f\n",
                       distanceToPaper(statistics), distanceCounted(statistics));
}

}  // namespace

std::string specimensCsv(const BreakagePlan& plan, std::span<const ItemResult> results) {
    std::string text =
        "experiment,diameter_um,velocity_mps,packing,largest_share,children,broken_by_largest,"
        "broken_by_meridional_crack\n";
    const auto items = plan.items();
    for (size_t item = 0; item < results.size(); ++item)
        for (size_t k = 0; k < items[item].size(); ++k) {
            const BreakageRun& run = items[item][k];
            const BreakageExperiment& experiment = plan.experiments[run.experiment];
            const Outcome& outcome = results[item].outcomes[k];
            text += experiment.name + line(",%g,%.6g,%u,%.6f,%u,%d,%d\n", micrometres(experiment, run.size),
                                           run.velocity, run.packing, outcome.largest, outcome.children,
                                           outcome.split, outcome.meridional);
        }
    return text;
}

std::string probabilityCsv(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics) {
    std::string text =
        "experiment,diameter_um,velocity_mps,specimens,broken,probability,wilson_low,wilson_high,"
        "broken_by_largest,broken_by_meridional_crack,both_rules,mean_children";
    for (uint32_t k = 0; k <= kMostChildren; ++k) text += line(",with_%u_children", k);
    text += "\n";
    for (size_t e = 0; e < statistics.size(); ++e)
        for (uint32_t size = 0; size < 2; ++size)
            for (size_t k = 0; k < statistics[e].velocities.size(); ++k) {
                const BreakageCell& cell = statistics[e].cells[size][k];
                const Interval wilson = wilsonInterval(cell.broken, cell.specimens);
                text += plan.experiments[e].name +
                        line(",%g,%.6g,%u,%u,%.6f,%.6f,%.6f,%u,%u,%u,%.4f",
                             micrometres(plan.experiments[e], size), statistics[e].velocities[k],
                             cell.specimens, cell.broken, cell.probability(), wilson.low, wilson.high,
                             cell.split, cell.meridional, cell.both, cell.meanChildren());
                for (const uint32_t count : cell.children) text += line(",%u", count);
                text += "\n";
            }
    return text;
}

std::string breakageJson(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics) {
    Json json{{"plan", plan.fingerprint()}, {"readings", Json::array()}};
    for (size_t e = 0; e < statistics.size(); ++e)
        json["readings"].push_back(readingJson(plan.experiments[e], statistics[e]));
    return jsonText(json, 1) + "\n";
}

std::string breakageTable(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics) {
    std::string text;
    for (size_t e = 0; e < statistics.size(); ++e) text += readingTable(plan.experiments[e], statistics[e]);
    return text;
}

GatheredResults gatherResults(const BreakagePlan& plan, const fs::path& folder) {
    const auto items = plan.items();
    std::vector<ItemResult> results;
    for (size_t item = 0; item < items.size(); ++item) {
        auto result = readItem(folder, plan, item, items[item]);
        if (!result)
            throw InputFileError("item " + std::to_string(item) + " of " + std::to_string(items.size()) +
                                 " is missing in " + folder.string() +
                                 "; run it by --index, or all that is missing without");
        results.push_back(std::move(*result));
    }
    const auto statistics = summarise(plan, results);
    requireWritable(folder / "specimens.csv");
    writeTextFile(folder / "specimens.csv", specimensCsv(plan, results));
    writeTextFile(folder / "probability.csv", probabilityCsv(plan, statistics));
    writeTextFile(folder / "breakage.json", breakageJson(plan, statistics));
    GatheredResults gathered{breakageTable(plan, statistics), true};
    const auto writeFigure = [&](const char* name, const std::string& svg) {
        writeTextFile(folder / name, svg);
        gathered.has_png = drawAsPng(folder / name) && gathered.has_png;
    };
    writeFigure("figure_1.svg", probabilityFigure(plan, statistics));
    writeFigure("figure_2a.svg", childrenFigure(plan, statistics, 0));
    writeFigure("figure_2b.svg", childrenFigure(plan, statistics, 1));
    return gathered;
}

}  // namespace demolish
