// SPDX-License-Identifier: Apache-2.0
// The stable step: power iteration against what the integrator really bears (physics.md D 19).
#include "sim_cuda/physics/random.h"
#include "sim_cuda/physics/time_step.h"
#include "sim_cuda/solver/cpu_substep_runner.h"
#include "sim_cuda/solver/device_solver.h"
#include "tests/physics/frequency_bound.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Stability : public OnTheCpu {
  protected:
    Stability() : setup_(freeBody(latticeBody(3, 3, 4, 0.1, 0.25))) {
        setup_.bodies[0].material.damping_ratio = 0;
        setup_.bodies[0].material.critical_velocity = 1e6;
        tables_ = buildSceneTables(setup_, {});
        for (uint32_t i = 0; i < tables_.counts.in_bodies; ++i)
            tables_.velocity[i] = {1e-4 * (uniformOf(7, 3 * i) - 0.5), 1e-4 * (uniformOf(7, 3 * i + 1) - 0.5),
                                   1e-4 * (uniformOf(7, 3 * i + 2) - 0.5)};
    }

    /// Largest squared speed after n substeps of `share` times 2 / omega_max.
    double speedAfter(double share, uint32_t n) {
        CpuBackend backend;
        SolverData<CpuBackend, double> data(backend, tables_, 0);
        data.uploadLaws(backend, buildLawTables(setup_, tables_, {}));
        NeighbourLists<CpuBackend, double> lists(backend, tables_.counts, tables_.largest_radius);
        StepParams<double> params = makeStepParams<double>(setup_.params, tables_);
        params.dt =
            share * criticalStep(tables_.body[0].report.highest_frequency / 1.01);  // without the margin
        params.breaking = 0;
        SubstepRunner<CpuBackend, double> runner(backend);
        runner.run(backend, data, lists.contacts(), params, false, n);
        double largest = 0;
        const auto state = data.particles.in(data.current);
        for (uint32_t i = 0; i < tables_.counts.in_bodies; ++i) {
            const double speed2 = length2(xyz(state.velocity[i]));
            if (!(speed2 < 1e6)) return 1e6;
            largest = std::max(largest, speed2);
        }
        return largest;
    }

    SceneSetup setup_;
    SceneTables tables_;
};

TEST_F(Stability, TheUndampedStepIsTheOneFound) {
    EXPECT_LT(speedAfter(0.95, 100'000), 1e-6);
    EXPECT_GE(speedAfter(1.05, 5'000), 1e6);
}

TEST_F(Stability, TheBoundWithoutEigenvaluesIsOnTheSafeSide) {
    const BodyConstants& body = tables_.body[0];
    double bound = 0;
    for (uint32_t i = 0; i < tables_.counts.in_bodies; ++i)
        for (uint32_t s = tables_.row_start[i]; s < tables_.row_start[i + 1]; ++s) {
            const BondSlot& slot = tables_.slots[s];
            const auto end = [&](uint32_t p) {
                return test::BondEnd{tables_.mass[p], tables_.inertia[p],
                                     static_cast<double>(tables_.row_start[p + 1] - tables_.row_start[p]),
                                     length(slot.rest) / 2};
            };
            bound = std::max(
                bound, test::frequencyBoundSquared(roundBond(slot.stiffness, body.shear_ratio, slot.radius),
                                                   end(i), end(slot.other)));
        }
    const double omega = body.report.highest_frequency / 1.01;
    EXPECT_GT(bound, omega * omega);
    EXPECT_LT(bound, 6 * omega * omega);
}

TEST_F(Stability, TheSofteningRuleGivesTheStepAskedFor) {
    const SofteningReport& report = tables_.body[0].report;
    EXPECT_NEAR(tables_.time_step, 1.0 / 60 / 300, 1e-12);
    EXPECT_NEAR(tables_.time_step * report.highest_frequency / 2, setup_.params.step_safety, 1e-9);
    EXPECT_NEAR(report.wave_speed, 0.68 * 0.5 * 60 * 300 * 0.1, 0.25 * report.wave_speed);
    setup_.params.soften = false;
    setup_.bodies[0].material.youngs_modulus = 2e9;
    const SceneTables stiff = buildSceneTables(setup_, {});
    EXPECT_NEAR(stiff.body[0].report.effective_modulus, 2e9, 1);
    EXPECT_LE(stiff.time_step * stiff.body[0].report.highest_frequency / 2,
              setup_.params.step_safety * (1 + 1e-9));
}

class StableStep : public OnEitherDevice {};

TEST_F(StableStep, AnUndampedBodyStaysBoundedAtNearlyTheWholeStep) {  // D 19, on the device under test
    SceneSetup setup = freeBody(latticeBody(3, 3, 4, 0.1, 0.25));
    setup.bodies[0].material.damping_ratio = 0;
    setup.bodies[0].material.critical_velocity = 1e6;
    setup.bodies[0].angular_velocity = {2, 1, -3};
    setup.params.step_safety = 0.95;
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = solver->stats().energy.kinetic;
    ASSERT_EQ(solver->advanceSubsteps(100'000), StepStatus::kOk);
    solver->measure();
    EXPECT_NEAR((solver->stats().energy.kinetic + solver->stats().energy.elastic) / before, 1, 0.05);
}

}  // namespace
}  // namespace demolish::tests
