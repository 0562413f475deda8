// A single pair and its record: bonded, broken, plain contact (physics.md A.6, D 22).
#include <gtest/gtest.h>

#include "sim_cuda/solver/cpu_substep_runner.h"
#include "sim_cuda/solver/device_solver.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {
namespace {

class Pair : public ::testing::Test {
  protected:
    Pair()
        : setup_(freeBody(latticeBody(2, 1, 1, kSize))),
          tables_(buildSceneTables(setup_, {})),
          data_(backend_, tables_, 0),
          lists_(backend_, tables_.counts, tables_.largest_radius),
          runner_(backend_),
          params_(makeStepParams<double>(setup_.params, tables_)) {
        data_.uploadLaws(backend_, buildLawTables(setup_, tables_, {}));
    }

    void setState(PairState state) {
        data_.bonds.link.span()[0].link = linkWord(1, state);
        data_.bonds.link.span()[1].link = linkWord(0, state);
    }
    PairState state(uint32_t end) const { return pairState(data_.bonds.link.view()[end]); }
    StateOut<double> now() { return data_.particles.out(data_.current); }
    void setDistance(double distance) {
        for (uint32_t i = 0; i < 2; ++i) now().position[i].x = (i == 0 ? -0.5 : 0.5) * distance;
    }
    void step(uint32_t n = 1) { runner_.run(backend_, data_, lists_.contacts(), params_, true, n); }
    double force(uint32_t i) { return length(xyz(now().velocity[i])) * tables_.mass[i] / params_.dt; }

    static constexpr double kSize = 0.1;
    CpuBackend backend_;
    SceneSetup setup_;
    SceneTables tables_;
    SolverData<CpuBackend, double> data_;
    NeighbourLists<CpuBackend, double> lists_;
    SubstepRunner<CpuBackend, double> runner_;
    StepParams<double> params_;
};

TEST_F(Pair, ABrokenPairSpunInPlaceFeelsNoNormalForce) {
    setState(PairState::kBroken);
    now().rotation[0] = {0, 0, 0.7071067811865476, 0.7071067811865476};
    step();
    const double unit = tables_.slots[0].stiffness * kSize;
    EXPECT_LT(force(0), 1e-12 * unit);
    EXPECT_LT(force(1), 1e-12 * unit);
}

TEST_F(Pair, TheCompressiveForceIsContinuousAcrossTheBreak) {
    setDistance(0.99 * kSize);
    step();
    const double bonded = force(0);
    for (uint32_t i = 0; i < 2; ++i) now().velocity[i] = {0, 0, 0, 0};
    setDistance(0.99 * kSize);
    setState(PairState::kBroken);
    step();
    EXPECT_NEAR(force(0) / bonded, 1, 1e-9);
    EXPECT_NEAR(bonded, tables_.slots[0].stiffness * 0.01 * kSize, 1e-6 * bonded);
}

TEST_F(Pair, ABrokenPairNeverPullsAndNeverHeals) {
    setState(PairState::kBroken);
    setDistance(1.02 * kSize);
    step();
    EXPECT_EQ(force(0), 0);
    EXPECT_EQ(state(0), PairState::kBroken);
    setDistance(1.0801 * kSize);
    step();
    EXPECT_EQ(state(0), PairState::kContact);
    EXPECT_EQ(state(1), PairState::kContact);
    setDistance(0.9 * kSize);
    step(5);
    EXPECT_EQ(state(0), PairState::kContact);
    EXPECT_GT(force(0), 0);
}

TEST_F(Pair, TheBondBreaksAtItsStrengthAndNotBefore) {
    const double strength = tables_.body[0].report.strength, area = kSize * kSize;
    const double limit = strength * tables_.slots[0].strength * area / tables_.slots[0].stiffness;
    setDistance(kSize + 0.9995 * limit);
    step();
    EXPECT_EQ(state(0), PairState::kBonded);
    for (uint32_t i = 0; i < 2; ++i) now().velocity[i] = {0, 0, 0, 0};
    setDistance(kSize + 1.0005 * limit);
    step();
    EXPECT_EQ(state(0), PairState::kBroken);
    EXPECT_EQ(state(1), PairState::kBroken);
    const double stored = 0.5 * tables_.slots[0].stiffness * limit * limit;
    EXPECT_NEAR(data_.ledger.view()[0].z / stored, 1, 2e-2);  // booked at the lower id, once
    EXPECT_EQ(data_.ledger.view()[1].z, 0);
}

}  // namespace
}  // namespace demolish::tests
