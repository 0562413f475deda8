// SPDX-License-Identifier: Apache-2.0
// Runs of a scene side by side, packing by packing.
#include "tests/physics/scenes/hand_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <ostream>

#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

/// Standard errors of a mean that chaos alone may bring.
constexpr double kErrors = 2;

/// Run k has seed k of the scene's own and on; `regimes`: with hand-over and sleep.
Shot shotOf(const HandOverScene& scene, bool regimes, int k) {
    Shot shot = smallScene(scene.name, scene.particles, scene.bodies);
    bringForward(shot, {.first = 0.05, .last = 0.35});
    shot.seed += static_cast<uint64_t>(k);
    if (scene.settled > 0) shot.settle_time = scene.settled;
    shot.hand_over = shot.sleeping = regimes;
    return shot;
}

void print(bool regimes, const SceneOutcome& o) {
    std::printf(
        "%s: closure %.4f, damping %.3f, friction %.3f, fracture %.3f; %g bonds broken, %zu fragments, "
        "%g of 1 %%, largest %.3f; most rigid %u, asleep %u\n",
        regimes ? "handed over" : "bonds", o.closure, o.damping, o.friction, o.fracture, o.broken,
        o.masses.size(), o.big, o.largest, o.most_rigid, o.most_asleep);
}

SceneOutcome runOf(const HandOverScene& scene, bool regimes, int k) {
    const SceneOutcome run = outcomeOf(shotOf(scene, regimes, k), scene.seconds);
    print(regimes, run);
    EXPECT_NEAR(run.closure, 1, 0.005);
    EXPECT_EQ(run.most_rigid > 10, regimes);
    EXPECT_EQ(run.most_asleep > 0, regimes);
    return run;
}

/// The same bodies and shots without and with.
struct TwoRuns {
    SceneOutcome bonded, handed;
};

/// What is compared of an outcome, and by how much its mean may differ; `relative`: over its mean without.
struct Quantity {
    const char* name;
    std::function<double(const SceneOutcome&)> of;
    double bound;
    bool relative = false;
};
std::vector<Quantity> quantities(const HandOverBounds& bounds) {
    using O = SceneOutcome;
    return {{"closure", [](const O& o) { return o.closure; }, bounds.closure},
            {"fracture", [](const O& o) { return o.fracture; }, bounds.fracture},
            {"what damps and rubs", [](const O& o) { return o.damping + o.friction; },
             bounds.damping_and_friction},
            {"damping", [](const O& o) { return o.damping; }, bounds.damping_or_friction},
            {"friction", [](const O& o) { return o.friction; }, bounds.damping_or_friction},
            {"bonds broken", [](const O& o) { return o.broken; }, bounds.broken, true},
            {"fragments of 1 %", [](const O& o) { return o.big; }, bounds.big, true},
            {"largest fragment", [](const O& o) { return o.largest; }, bounds.largest}};
}

void expectAlike(const std::vector<TwoRuns>& runs, const Quantity& quantity) {
    const double n = static_cast<double>(runs.size());
    double without = 0, sum = 0, squares = 0;
    for (const TwoRuns& run : runs) {
        const double bonded = quantity.of(run.bonded), more = quantity.of(run.handed) - bonded;
        without += bonded / n;
        sum += more;
        squares += more * more;
    }
    const double mean = sum / n, error = std::sqrt(std::max(0.0, squares - n * mean * mean) / (n * (n - 1))),
                 bound = quantity.bound * (quantity.relative ? without : 1);
    std::printf("%s: %.4g, with hand-over %+.4g, standard error %.2g, bound %.4g\n", quantity.name, without,
                mean, error, bound);
    EXPECT_LE(std::abs(mean), std::max(bound, kErrors * error)) << quantity.name;
    EXPECT_LE(error, bound) << quantity.name << ": too few runs to tell";
}

/// Fragment k of the mean is the mean of the runs' k-th largest.
SceneOutcome meanMasses(const std::vector<TwoRuns>& runs, SceneOutcome TwoRuns::*which) {
    SceneOutcome mean;
    for (const TwoRuns& run : runs) {
        const std::vector<double>& masses = (run.*which).masses;
        mean.masses.resize(std::max(mean.masses.size(), masses.size()));
        for (size_t k = 0; k < masses.size(); ++k)
            mean.masses[k] += masses[k] / static_cast<double>(runs.size());
    }
    return mean;
}

}  // namespace

std::string nameOf(const HandOverScene& scene) {
    return scene.name;
}
void PrintTo(const HandOverScene& scene, std::ostream* out) {
    *out << scene.name;
}

void expectHandOverUnseen(const HandOverScene& scene, const HandOverBounds& bounds) {
    std::vector<TwoRuns> runs;
    for (int k = 0; k < scene.runs; ++k) {
        runs.push_back({runOf(scene, false, k), runOf(scene, true, k)});
        EXPECT_GT(runs.back().bonded.broken, 100);
    }
    for (const Quantity& quantity : quantities(bounds)) expectAlike(runs, quantity);
    const double masses =
        massDistance(meanMasses(runs, &TwoRuns::bonded), meanMasses(runs, &TwoRuns::handed));
    std::printf("means of masses differ by %.3f\n", masses);
    EXPECT_LT(masses, bounds.masses);
}

void expectMomentumKept(const HandOverScene& scene) {
    for (const bool hand_over : {false, true}) {
        Shot shot = smallScene(scene.name, scene.particles, scene.bodies);
        shot.hand_over = hand_over;
        shot.sleeping = false;  // what sleeps is stopped: there is no floor here that could take up the rest
        const Straying straying = strayingOf(shot, 0.03, 40);
        std::printf("momentum strays by %.1e, angular momentum by %.1e; most rigid %u\n", straying.linear,
                    straying.angular, straying.most_rigid);
        EXPECT_GT(straying.broken, 80u);
        EXPECT_EQ(straying.most_rigid > 2, hand_over);
        EXPECT_LT(straying.linear, 2e-6);
        EXPECT_LT(straying.angular, 2e-6);
    }
}

}  // namespace demolish::tests
