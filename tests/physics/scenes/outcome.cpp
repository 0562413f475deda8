// SPDX-License-Identifier: Apache-2.0
// Runs that end in numbers.
#include "tests/physics/scenes/outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

double lengthOf(const Double3& v) {
    return std::hypot(v.x, v.y, v.z);
}
Double3 minus(const Double3& a, const Double3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Mass of every fragment of each body, over the body's.
std::vector<std::vector<double>> fragmentShares(const SceneSetup& setup,
                                                const std::vector<uint32_t>& fragment) {
    std::vector<std::vector<double>> shares;
    size_t at = 0;
    for (const BodyInstance& instance : setup.bodies) {
        std::map<uint32_t, double> volumes;
        double whole = 0;
        for (const Particle& particle : instance.body->particles) {
            volumes[fragment[at++]] += particle.volume;
            whole += particle.volume;
        }
        shares.emplace_back();
        for (const auto& [slot, volume] : volumes) shares.back().push_back(volume / whole);
    }
    return shares;
}

void watch(const FrameStats& stats, uint32_t& most_rigid, uint32_t& most_asleep) {
    most_rigid = std::max(most_rigid, stats.rigid_fragments);
    most_asleep = std::max(most_asleep, stats.sleeping_fragments);
}

/// m, from the origin: the lever of round-off in a momentum.
double farthestOut(const std::vector<Float3>& positions) {
    double farthest = 0;
    for (const Float3& x : positions) farthest = std::max<double>(farthest, std::hypot(x.x, x.y, x.z));
    return farthest;
}

}  // namespace

SceneOutcome outcomeOf(const Shot& shot, double seconds) {
    SceneRun run(shot, {.ledger = true});
    SceneOutcome outcome;
    while (run.stats().time < seconds - 1e-6 && !testing::Test::HasFatalFailure()) {
        run.runTo(run.stats().time + 1 / shot.fps);
        watch(run.stats(), outcome.most_rigid, outcome.most_asleep);
    }
    const EnergyBalance balance = run.energy();
    const double in = balance.broughtIn();
    outcome.closure = balance.closure();
    outcome.damping = (balance.now.damping - balance.start.damping) / in;
    outcome.friction = (balance.now.friction - balance.start.friction) / in;
    outcome.fracture = (balance.now.fracture - balance.start.fracture) / in;
    outcome.broken = run.stats().bonds_broken;
    const auto bodies = fragmentShares(run.setup(), run.fragments());
    for (const auto& shares : bodies) {
        outcome.largest +=
            *std::max_element(shares.begin(), shares.end()) / static_cast<double>(bodies.size());
        outcome.big += static_cast<double>(
            std::count_if(shares.begin(), shares.end(), [](double share) { return share >= 0.01; }));
        outcome.masses.insert(outcome.masses.end(), shares.begin(), shares.end());
    }
    std::sort(outcome.masses.rbegin(), outcome.masses.rend());
    return outcome;
}

double massDistance(const SceneOutcome& a, const SceneOutcome& b) {
    const auto massAt = [](const std::vector<double>& masses, size_t k) {
        return k < masses.size() ? masses[k] : 0.0;
    };
    double whole = 0, differing = 0;
    for (size_t k = 0; k < std::max(a.masses.size(), b.masses.size()); ++k) {
        whole += massAt(a.masses, k);
        differing += 0.5 * std::abs(massAt(a.masses, k) - massAt(b.masses, k));
    }
    return differing / whole;
}

Straying strayingOf(Shot shot, double flight, uint32_t frames) {
    bringForward(shot, {.first = flight, .last = flight});
    for (TimedBall& ball : shot.balls) ball.flight_time = flight;
    SceneRun run(shot, {.ledger = true, .in_free_space = true});
    const FrameStats start = run.measured();
    const double momentum = lengthOf(start.linear_momentum);
    Straying straying;
    uint32_t asleep = 0;
    for (uint32_t frame = 0; frame < frames && !testing::Test::HasFatalFailure(); ++frame) {
        run.runTo(run.stats().time + 1 / shot.fps);
        watch(run.stats(), straying.most_rigid, asleep);
        const FrameStats now = run.measured();
        straying.linear =
            std::max(straying.linear, lengthOf(minus(now.linear_momentum, start.linear_momentum)) / momentum);
        straying.angular =
            std::max(straying.angular, lengthOf(minus(now.angular_momentum, start.angular_momentum)) /
                                           (momentum * std::max(shot.height, farthestOut(run.positions()))));
    }
    straying.broken = run.stats().bonds_broken;
    return straying;
}

}  // namespace demolish::tests
