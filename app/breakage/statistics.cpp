// SPDX-License-Identifier: Apache-2.0
// Counting.
#include "app/breakage/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demolish {
namespace {

void count(const Outcome& outcome, const BreakageExperiment& experiment, BreakageCell& cell) {
    ++cell.specimens;
    cell.split += outcome.split ? 1 : 0;
    cell.meridional += outcome.meridional ? 1 : 0;
    cell.both += outcome.split && outcome.meridional ? 1 : 0;
    if (!isBroken(outcome, experiment.rule, experiment.criteria)) return;
    ++cell.broken;
    cell.children_in_all += outcome.children;
    ++cell.children[std::min(outcome.children, kMostChildren)];
}

/// Energies of all items of an experiment, J, before they are made shares.
void addEnergies(const ItemResult& result, BreakageStatistics& statistics, double& impact) {
    impact += result.impact_energy;
    statistics.kinetic += result.energy.kinetic;
    statistics.damping += result.energy.damping;
    statistics.friction += result.energy.friction;
    statistics.fracture += result.energy.fracture;
    statistics.sum += result.energy.kinetic + result.energy.elastic + result.energy.damping +
                      result.energy.friction + result.energy.fracture;
}

/// Linear between velocities, the end values beyond.
template <class Share>
double shareAt(const BreakageStatistics& statistics, uint32_t size, double velocity, const Share& share) {
    const auto& v = statistics.velocities;
    const auto& cells = statistics.cells[size];
    if (velocity <= v.front()) return share(cells.front());
    for (size_t k = 1; k < v.size(); ++k) {
        if (velocity > v[k]) continue;
        const double part = (velocity - v[k - 1]) / (v[k] - v[k - 1]);
        return share(cells[k - 1]) + part * (share(cells[k]) - share(cells[k - 1]));
    }
    return share(cells.back());
}

/// Of `measured`, which gives a share for a stated point, to all of them.
template <class Measured>
double distanceOf(const Measured& measured) {
    double sum = 0;
    for (const StatedPoint& point : kStated) {
        const double miss = measured(point) - point.probability;
        sum += miss * miss;
    }
    return std::sqrt(sum / kStated.size());
}

}  // namespace

Interval wilsonInterval(uint32_t hits, uint32_t trials, double z) {
    if (trials == 0) return {};
    const double n = trials, p = hits / n, z2 = z * z;
    const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
    const double half = z / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
    return {hits == 0 ? 0 : centre - half, hits == trials ? 1 : centre + half};
}

std::vector<BreakageStatistics> summarise(const BreakagePlan& plan, std::span<const ItemResult> results) {
    std::vector<BreakageStatistics> all(plan.experiments.size());
    std::vector<double> impact(all.size(), 0);
    for (size_t k = 0; k < all.size(); ++k) {
        all[k].velocities = velocitiesOf(plan.experiments[k]);
        for (auto& cells : all[k].cells) cells.resize(all[k].velocities.size());
    }
    const auto items = plan.items();
    for (size_t item = 0; item < results.size(); ++item) {
        const size_t k = items[item][0].experiment;
        BreakageStatistics& statistics = all[k];
        for (size_t s = 0; s < items[item].size(); ++s) {
            const BreakageRun& run = items[item][s];
            count(results[item].outcomes[s], plan.experiments[k], statistics.cells[run.size][run.speed]);
        }
        addEnergies(results[item], statistics, impact[k]);
        statistics.particles += results[item].particles;
        statistics.substeps = std::max(statistics.substeps, results[item].substeps);
        statistics.time_step = results[item].time_step;
    }
    for (size_t k = 0; k < all.size(); ++k)
        for (double* energy :
             {&all[k].kinetic, &all[k].damping, &all[k].friction, &all[k].fracture, &all[k].sum})
            *energy /= impact[k];
    return all;
}

double probabilityAt(const BreakageStatistics& statistics, uint32_t size, double velocity) {
    return shareAt(statistics, size, velocity, [](const BreakageCell& cell) { return cell.probability(); });
}

double countedAt(const BreakageStatistics& statistics, uint32_t size, double velocity) {
    return shareAt(statistics, size, velocity, [](const BreakageCell& cell) {
        return cell.specimens > 0 ? double(cell.threeToFive()) / cell.specimens : 0;
    });
}

double velocityAt(const BreakageStatistics& statistics, uint32_t size, double p) {
    const auto& v = statistics.velocities;
    const auto& cells = statistics.cells[size];
    for (size_t k = 0; k < v.size(); ++k) {
        const double here = cells[k].probability();
        if (here < p) continue;
        if (k == 0) return here == p ? v[0] : std::numeric_limits<double>::quiet_NaN();
        const double before = cells[k - 1].probability();
        return v[k - 1] + (v[k] - v[k - 1]) * (p - before) / (here - before);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double distanceToPaper(const BreakageStatistics& statistics) {
    return distanceOf(
        [&](const StatedPoint& point) { return probabilityAt(statistics, point.size, point.velocity); });
}

double distanceCounted(const BreakageStatistics& statistics) {
    return distanceOf([&](const StatedPoint& point) {
        return point.with_figure_2 ? countedAt(statistics, point.size, point.velocity)
                                   : probabilityAt(statistics, point.size, point.velocity);
    });
}

double shareOfThreeToFive(const BreakageStatistics& statistics, uint32_t size) {
    uint32_t fitting = 0, broken = 0;
    for (const BreakageCell& cell : statistics.cells[size]) {
        broken += cell.broken;
        fitting += cell.threeToFive();
    }
    return broken > 0 ? double(fitting) / broken : 0;
}

}  // namespace demolish
