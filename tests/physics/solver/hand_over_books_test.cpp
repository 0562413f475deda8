// SPDX-License-Identifier: Apache-2.0
// What is booked when bonds come to rest in the middle of a swing (B.1, architecture 9).
#include <algorithm>
#include <cmath>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class HandOverBooks : public OnEitherDevice {};

struct Books {
    double impact = 0;  ///< J, kinetic at the start
    double off = 0;     ///< of that, the most by which the sum was off after a frame
    int rests = 0;      ///< frames after which what had its bonds before was rigid
    uint32_t broken = 0;
};

Books follow(const SceneSetup& setup, int frames) {
    auto solver = makeSolver(setup);
    solver->measure();
    const double start = energySum(solver->stats().energy);
    Books books{solver->stats().energy.kinetic};
    bool had_bonds = false;
    for (int frame = 0; frame < frames; ++frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const FrameStats& stats = solver->stats();
        books.off = std::max(books.off, std::abs(energySum(stats.energy) - start) / books.impact);
        const bool has_bonds = stats.bonded_particles > 0;
        if (had_bonds && !has_bonds) ++books.rests;
        had_bonds = has_bonds;
    }
    books.broken = solver->stats().bonds_broken;
    return books;
}

/// A bar, hit at one end by a ball, swings from end to end when its bonds come to rest.
TEST_F(HandOverBooks, WhatSwingsIsBookedAsItIs) {
    for (const uint32_t substeps : {40u, 60u, 90u}) {
        SceneSetup setup = freeBody(latticeBody(2, 2, 8, 0.05, 0.2));
        setup.bodies[0].material.damping_ratio = 0.05;
        setup.bodies[0].material.critical_velocity = 20;
        setup.params.substeps = substeps;
        setup.params.hand_over = true;
        setup.params.sleeping = false;
        Projectile ball;
        ball.radius = 0.04;
        ball.position = {0.01, 0.06, -0.3};
        ball.velocity = {0, 0, 6};
        setup.projectiles = {ball};
        const Books books = follow(setup, 12);
        EXPECT_GT(books.rests, 0);
        EXPECT_EQ(books.broken, 0u);
        EXPECT_LT(books.off, 3e-4);
    }
}

}  // namespace
}  // namespace demolish::tests
