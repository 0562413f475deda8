// SPDX-License-Identifier: Apache-2.0
// A thousand revolutions in double, a hundred in single precision (physics.md D 16, at full length).
#include <cmath>

#include "sim_cuda/solver/double_solver.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class LongSpin : public OnEitherDevice {};
class LongSpinDouble : public OnTheCpu {};

constexpr double kTurn = 6.283185307179586, kSpin = 77;  // rad, rad/s

struct Drift {
    double angular = 0, energy = 0, revolutions = 0;
};

/// After a first revolution, in which the body takes on its stretch: leapfrog keeps the energy of what turns
/// by an angle of a in a step but for a share of a^2, and of what is not stretched yet that is another one.
Drift spinFor(Solver& solver, double revolutions) {
    const auto first = static_cast<uint32_t>(kTurn / kSpin / solver.stats().time_step);
    EXPECT_EQ(solver.advanceSubsteps(first), StepStatus::kOk);
    solver.measure();
    const Double3 before = solver.stats().angular_momentum;
    const EnergyLedger start = solver.stats().energy;
    const auto substeps = static_cast<uint64_t>(revolutions * kTurn / kSpin / solver.stats().time_step);
    for (uint64_t done = 0; done < substeps; done += 100'000)
        EXPECT_EQ(solver.advanceSubsteps(100'000), StepStatus::kOk);
    solver.measure();
    EXPECT_EQ(solver.stats().bonds_broken, 0u);
    const Double3 after = solver.stats().angular_momentum;
    const EnergyLedger end = solver.stats().energy;
    return {std::hypot(after.x - before.x, after.y - before.y, after.z - before.z) /
                std::hypot(before.x, before.y, before.z),
            std::abs((end.kinetic + end.elastic) / (start.kinetic + start.elastic) - 1),
            kSpin * solver.stats().time / kTurn};
}

TEST_F(LongSpinDouble, AThousandRevolutions) {
    const Drift drift = spinFor(*makeCpuSolverDouble(spinningBody(kSpin)), 1000);
    EXPECT_GE(drift.revolutions, 1000);
    EXPECT_LT(drift.angular, 1e-11);
    EXPECT_LT(drift.energy, 1e-5);
}

TEST_F(LongSpin, AHundredRevolutionsInSinglePrecision) {
    const Drift drift = spinFor(*makeSolver(spinningBody(kSpin)), 100);
    EXPECT_GE(drift.revolutions, 100);
    EXPECT_LT(drift.angular, 1e-4);
    EXPECT_LT(drift.energy, 1e-4);
}

}  // namespace
}  // namespace demolish::tests
