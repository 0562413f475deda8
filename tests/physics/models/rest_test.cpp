// SPDX-License-Identifier: Apache-2.0
// Standing still, coming to rest, and a minute of a pile (models.md E.4, E.5). Slow.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/physics/models/packed_body.h"
#include "tests/physics/models/shots.h"
#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Rest : public OnEitherDevice {};

std::vector<ParticleInstance> particlesOf(Solver& solver, const SceneSetup& setup) {
    return exportedFrame(solver, streamSizes(setup).particles).particles;
}

struct Standing {
    double farthest = 0;  ///< m, that a particle moved
    double stress = 0;    ///< over strength
    uint32_t broken = 0;
};

/// Settles, then stands free for a second and a half.
Standing stand(std::shared_ptr<const BreakableBody> body, double critical_velocity, uint32_t cells,
               uint32_t substeps, double settle_seconds) {
    SceneSetup setup = standing(std::move(body), sheetMaterial(critical_velocity, cells), substeps);
    setup.params.gravity = {0, -9.81, 0};
    setup.params.settle_time = settle_seconds;
    setup.params.ledger = false;
    auto solver = makeSolver(setup);
    const auto before = particlesOf(*solver, setup);
    for (int frame = 0; frame < 90; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const auto after = particlesOf(*solver, setup);
    Standing result;
    for (size_t i = 0; i < setup.bodies[0].body->particles.size(); ++i) {
        const Float3 a = before[i].position, b = after[i].position;
        result.farthest = std::max<double>(result.farthest, std::hypot(b.x - a.x, b.y - a.y, b.z - a.z));
    }
    result.stress = solver->stats().max_stress_ratio;
    result.broken = solver->stats().bonds_broken;
    return result;
}

TEST_F(Rest, ModelsStandStill) {  // E.4; the wolf stands in tests/physics/scenes
    struct Row {
        const char* model;
        double height, critical_velocity, settle, most;  ///< m, m/s, s, m
        uint32_t particles, cells, substeps;
    };
    for (const Row& row :
         {Row{"column", 2.3, 4, 0.8, 1e-4, 1000, 50, 150}, Row{"vase", 0.5, 6, 0.8, 1e-4, 1500, 60, 200},
          Row{"rabbit", 0.348, 2.5, 0.8, 4e-4, 1000, 35, 200}}) {
        const Standing s = stand(modelBody(row.model, row.height, row.particles, 1), row.critical_velocity,
                                 row.cells, row.substeps, row.settle);
        printf("%s: %.3g mm, stress %.2f, broken %u\n", row.model, 1000 * s.farthest, s.stress, s.broken);
        EXPECT_EQ(s.broken, 0u) << row.model;
        EXPECT_LT(s.farthest, row.most) << row.model;
        EXPECT_LT(s.stress, 0.7) << row.model;
    }
}

TEST_F(Rest, AHeapOfShardsComesToRest) {  // E.5: mu_r .3, e .1: 1 moving at 2 s, 0 at 3 s
    Material material = sheetMaterial(2, 60);
    material.rolling_friction = 0.3;
    material.restitution = 0.1;
    SceneSetup setup = dropped(modelBody("vase", 0.5, 800, 1), material, 150, {0.3, 0, 0.4}, 3);
    setup.params.gravity = {0, -9.81, 0};
    setup.params.ledger = false;
    auto solver = makeSolver(setup);
    PieceCounter counter(setup);
    Pieces pieces;
    for (int frame = 0; frame < 210; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        if (frame == 203) counter.count(*solver);
    }
    pieces = counter.count(*solver, 6.0 / 60);
    solver->measure();
    const double speed = std::sqrt(std::max(0.0, 2 * solver->stats().energy.kinetic) / solver->stats().mass);
    printf("%u pieces, %u moving, v_rms %.4f\n", solver->stats().fragments, pieces.moving, speed);
    EXPECT_GT(solver->stats().fragments, 40u);
    EXPECT_LE(pieces.moving, solver->stats().fragments / 20);
    EXPECT_LT(speed, 0.06);
}

/// How a pile is moved.
struct PileRegimes {
    const char* name;
    bool hand_over, sleeping;
};

/// A brick thrown to pieces on the floor.
SceneSetup pile(const PileRegimes& regimes) {
    SceneSetup setup = freeBody(latticeBody(5, 5, 5, 0.05, 0.2));
    setup.bodies[0].position = {0, 0.25, 0};
    setup.bodies[0].rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
    setup.bodies[0].velocity = {0, -4, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {0, -9.81, 0};
    setup.params.substeps = 60;
    setup.params.hand_over = regimes.hand_over;
    setup.params.sleeping = regimes.sleeping;
    return setup;
}

struct Moment {
    EnergyLedger energy;
    std::vector<ParticleInstance> particles;
    double mechanical() const { return energy.kinetic + energy.elastic + energy.potential; }
    double booked() const { return mechanical() + energy.damping + energy.friction + energy.fracture; }
};
Moment momentOf(Solver& solver, const SceneSetup& setup) {
    solver.measure();
    return {solver.stats().energy, particlesOf(solver, setup)};
}

/// As the program runs it, with bonds to the end, and so kept from sleeping.
class Pile : public Rest, public testing::WithParamInterface<PileRegimes> {
  protected:
    /// After 10, 20 .. 70 s.
    std::vector<Moment> minute() {
        const SceneSetup setup = pile(GetParam());
        auto solver = makeSolver(setup);
        std::vector<Moment> moments;
        for (int look = 0; look < 7; ++look) {
            for (int frame = 0; frame < 10 * 60; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
            moments.push_back(momentOf(*solver, setup));
        }
        EXPECT_GT(solver->stats().bonds_broken, solver->stats().bonds / 3);
        return moments;
    }
};

/// No energy gain, no drift; no creep where what rests may sleep. Rolling resistance is viscous at small
/// spins, so that cells which are kept awake roll on by millimetres.
TEST_P(Pile, LiesForAMinute) {
    const std::vector<Moment> moments = minute();
    const double size = moments[0].mechanical();
    for (size_t k = 1; k < moments.size(); ++k) {
        const Moment &now = moments[k], &last = moments[k - 1];
        EXPECT_LE(now.mechanical(), last.mechanical() + 1e-5 * size) << 10 * (k + 1) << " s";
        EXPECT_GE(now.energy.friction, last.energy.friction - 1e-5 * size) << 10 * (k + 1) << " s";
        EXPECT_NEAR(now.booked() / moments[0].booked(), 1, 1e-5) << 10 * (k + 1) << " s";
    }
    double farthest = 0;
    for (size_t i = 0; i < 125; ++i) {
        const Float3 a = moments.front().particles[i].position, b = moments.back().particles[i].position;
        farthest = std::max<double>(farthest, std::hypot(b.x - a.x, b.y - a.y, b.z - a.z));
    }
    printf("farthest way %.3g mm\n", 1000 * farthest);
    if (GetParam().sleeping) {
        EXPECT_LT(farthest, 1e-3);
    }
    EXPECT_LT(moments.back().energy.kinetic, 1e-5 * size);
}

INSTANTIATE_TEST_SUITE_P(Regimes, Pile,
                         testing::Values(PileRegimes{"AsItRuns", true, true},
                                         PileRegimes{"WithBondsAlone", false, true},
                                         PileRegimes{"KeptAwake", false, false}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace demolish::tests
