// SPDX-License-Identifier: Apache-2.0
// Charts of a sweep.
#include "app/breakage/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/breakage/chart.h"

namespace demolish {
namespace {

constexpr const char *kSizeColours[2] = {"#1f5fa8", "#c44e1a"}, *kPaleColours[2] = {"#84aad6", "#e0a083"};
constexpr const char* kDashes[5] = {"6 4", "2 3", "9 3 2 3", "12 4", "4 2 1 2"};
/// From pale to dark: the more children, the darker. 0 stands for crumbs alone.
constexpr const char* kChildColours[kMostChildren + 1] = {"#e8e8e8", "#d4d4d4", "#fde0a8", "#f6b65c",
                                                          "#ea8436", "#c8501f", "#8c2d16", "#4d170d"};

std::string format(const char* pattern, double value) {
    char text[160];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

std::string sizeName(const BreakageExperiment& experiment, uint32_t size) {
    const double micrometres = experiment.diameters[size] * 1e6;
    return micrometres < 1000 ? format("%g µm", micrometres) : format("%g m", experiment.diameters[size]);
}

ChartAxis velocityAxis(const std::vector<BreakageStatistics>& all) {
    double low = all[0].velocities.front(), high = all[0].velocities.back();
    for (const auto& statistics : all) {
        low = std::min(low, statistics.velocities.front());
        high = std::max(high, statistics.velocities.back());
    }
    const double step = high - low <= 4 ? 0.5 : high - low <= 12 ? 1 : high - low <= 60 ? 5 : 20;
    ChartAxis axis{"impact velocity, m/s", step * std::floor(low / step - 0.2),
                   step * std::ceil(high / step + 0.2), step, step < 1 ? 1 : 0};
    axis.low = std::max(axis.low, 0.0);
    return axis;
}

ChartSeries probabilityLine(const BreakageExperiment& experiment, const BreakageStatistics& statistics,
                            uint32_t size, size_t reading) {
    ChartSeries series;
    series.label = sizeName(experiment, size) + ", " + experiment.title;
    series.colour = kSizeColours[size];
    series.x = statistics.velocities;
    for (const BreakageCell& cell : statistics.cells[size]) {
        series.y.push_back(cell.probability());
        if (reading > 0) continue;
        const Interval interval = wilsonInterval(cell.broken, cell.specimens);
        series.error_low.push_back(interval.low);
        series.error_high.push_back(interval.high);
    }
    if (reading == 0) {
        series.width = 3;
        series.error_shift = size == 0 ? -3 : 3;
    } else {
        series.colour = kPaleColours[size];
        series.width = 1.5;
        series.marker = 0;
        series.dash = kDashes[(reading - 1) % std::size(kDashes)];
    }
    return series;
}

std::string ruleInWords(const BreakageExperiment& experiment) {
    switch (experiment.rule) {
        case BreakRule::kMeridional:
            return "Broken: a crack runs through the whole specimen.";
        case BreakRule::kFlaps:
            return format("Broken: at least %g children.", experiment.criteria.flaps);
        case BreakRule::kLargest:
            break;
    }
    return "Broken: largest fragment below " + format("%g %%", 100 * experiment.criteria.intact_share) +
           " of the volume.";
}

bool isThePapersSize(const BreakageExperiment& experiment, uint32_t size) {
    return std::fabs(experiment.diameters[size] - (size == 0 ? 24e-6 : 36e-6)) < 1e-9;
}

void addStatedPoints(const BreakageExperiment& experiment, Chart& chart) {
    for (const uint32_t size : {1u, 0u}) {
        if (!isThePapersSize(experiment, size)) continue;
        ChartSeries points;
        points.label = "stated in the paper, " + sizeName(experiment, size);
        points.colour = kSizeColours[size];
        points.width = 0;
        points.marker = 8;
        points.open_diamond = true;
        for (const StatedPoint& point : kStated)
            if (point.size == size) {
                points.x.push_back(point.velocity);
                points.y.push_back(point.probability);
            }
        chart.series.push_back(points);
    }
}

/// A sweep may end before the points that the paper states.
void reachAllPoints(Chart& chart) {
    for (const ChartSeries& series : chart.series)
        for (const double velocity : series.x) {
            while (velocity < chart.x.low) chart.x.low -= chart.x.step;
            while (velocity > chart.x.high) chart.x.high += chart.x.step;
        }
}

}  // namespace

std::string probabilityFigure(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics) {
    Chart chart;
    chart.title = "Probability of breakage on a rigid wall";
    chart.x = velocityAxis(statistics);
    chart.y = {"share of specimens broken", 0, 1, 0.1, 1};
    for (size_t k = statistics.size(); k-- > 0;)
        for (const uint32_t size : {1u, 0u})
            chart.series.push_back(probabilityLine(plan.experiments[k], statistics[k], size, k));
    addStatedPoints(plan.experiments[0], chart);
    reachAllPoints(chart);
    const BreakageExperiment& first = plan.experiments[0];
    chart.note = format("%g random packings a point; bars: 95 %% Wilson intervals. ", first.packings) +
                 ruleInWords(first);
    return chartSvg(chart);
}

std::string childrenFigure(const BreakagePlan& plan, const std::vector<BreakageStatistics>& statistics,
                           uint32_t size) {
    const BreakageExperiment& experiment = plan.experiments[0];
    const BreakageStatistics& sweep = statistics[0];
    Chart chart;
    chart.title = "Children of broken specimens, " + sizeName(experiment, size);
    chart.x = velocityAxis({sweep});
    const double step = std::max(1.0, 5 * std::ceil(experiment.packings / 50.0));
    chart.y = {"broken specimens of " + format("%g", experiment.packings), 0,
               std::max(1.0 * experiment.packings, step), step, 0};
    chart.bars.x = sweep.velocities;
    chart.bars.width = sweep.velocities.size() > 1 ? 0.7 * (sweep.velocities[1] - sweep.velocities[0]) : 1;
    for (uint32_t k = 0; k <= kMostChildren; ++k) {
        ChartStack::Part part;
        part.label =
            format("%g", k) + (k == kMostChildren ? " or more" : "") + (k == 1 ? " child" : " children");
        part.colour = kChildColours[k];
        double total = 0;
        for (const BreakageCell& cell : sweep.cells[size]) {
            part.heights.push_back(cell.children[k]);
            total += cell.children[k];
        }
        if (total > 0) chart.bars.parts.push_back(part);
    }
    if (isThePapersSize(experiment, size))
        for (const StatedPoint& point : kStated)
            if (point.size == size && point.velocity == 43)
                chart.series.push_back(
                    {.label = format("broken in all at 43 m/s,\nstated in the paper: %.0f of 30",
                                     30 * point.probability),
                     .x = {point.velocity},
                     .y = {point.probability * experiment.packings},
                     .error_low = {},
                     .error_high = {},
                     .width = 0,
                     .dash = "",
                     .marker = 8,
                     .open_diamond = true});
    reachAllPoints(chart);
    chart.note = format("Children: fragments of at least %g %% of the specimen's volume.",
                        100 * experiment.criteria.child_share) +
                 format("\nThe paper: between 3 and 5. Here %.0f %% of the broken specimens.",
                        100 * shareOfThreeToFive(sweep, size));
    return chartSvg(chart);
}

}  // namespace demolish
