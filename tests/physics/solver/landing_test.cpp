// SPDX-License-Identifier: Apache-2.0
// A rigid piece that rocks, or comes down from a few millimetres, comes to rest (models.md E.5). What lands
// faster bounces as it does with its bonds: regimes_test.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class RigidLanding : public OnEitherDevice {};

/// A block of 216 cells that only rigid steps move; `turn` about x, rad; `height`, m, of its lowest point.
SceneSetup rigidBlock(double turn, double height) {
    constexpr double kEdge = 0.18;
    SceneSetup setup = with(freeBody(latticeBody(6, 6, 6, kEdge / 6)), {true, false});
    setup.bodies[0].threshold_share = 10;
    setup.bodies[0].material.critical_velocity = 10;
    setup.bodies[0].rotation = {static_cast<float>(std::sin(turn / 2)), 0, 0,
                                static_cast<float>(std::cos(turn / 2))};
    setup.bodies[0].position = {0, static_cast<float>(height + kEdge / 2 * std::abs(std::sin(turn))), 0};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 200;
    return setup;
}

/// m/s, root of the mean square, after every frame. Kinetic and potential energy may never grow, but by what
/// contacts have stored.
std::vector<double> speeds(const SceneSetup& setup, int frames) {
    auto solver = makeSolver(setup);
    std::vector<double> speeds;
    double least = 1e30;
    for (int frame = 0; frame < frames; ++frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const EnergyLedger& e = solver->stats().energy;
        const double total = e.kinetic + e.potential + e.elastic;
        EXPECT_LT(total, least + 2e-3 * std::abs(least)) << frame;
        least = std::min(least, total);
        speeds.push_back(std::sqrt(std::max(0.0, 2 * e.kinetic) / solver->stats().mass));
    }
    EXPECT_EQ(solver->stats().rigid_fragments, 1u);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    return speeds;
}

/// m/s, the fastest from that frame on.
double fastestFrom(const std::vector<double>& speeds, size_t frame) {
    return *std::max_element(speeds.begin() + static_cast<std::ptrdiff_t>(frame), speeds.end());
}

/// Dropped from 2 mm, flat: one bounce and it lies.
TEST_F(RigidLanding, AFallOfTwoMillimetresEndsAtOnce) {
    const std::vector<double> v = speeds(rigidBlock(0, 0.002), 20);
    std::printf("%.3f m/s after a frame, %.3f after three, %.4f at last\n", v[0], v[2], v.back());
    EXPECT_GT(v[0], 0.1) << "it fell";
    EXPECT_LT(fastestFrom(v, 4), 1e-3);
}

/// On an edge, it rocks from side to side on its corners, and each time loses what its restitution takes.
TEST_F(RigidLanding, ABlockThatRocksComesToRest) {
    struct Row {
        double turn;   ///< rad
        size_t frame;  ///< at rest from here on
    };
    for (const Row& row : {Row{0.12, 14}, Row{0.3, 28}}) {
        const std::vector<double> v = speeds(rigidBlock(row.turn, 0.002), 60);
        std::printf("turned %.2f: %.3f m/s at most, %.4f from frame %zu on\n", row.turn, fastestFrom(v, 0),
                    fastestFrom(v, row.frame), row.frame);
        EXPECT_GT(fastestFrom(v, 0), 0.2) << "it rocked";
        EXPECT_LT(fastestFrom(v, row.frame), 0.02);
    }
}

}  // namespace
}  // namespace demolish::tests
