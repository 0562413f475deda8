// SPDX-License-Identifier: Apache-2.0
// Two cubes and the record of their bond, stepped by the substep runner: what pair tests look into.
#pragma once
#include "sim_cuda/solver/cpu_substep_runner.h"
#include "sim_cuda/solver/device_solver.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {

/// In double precision, on the CPU.
class Pair : public OnTheCpu {
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
    /// Both ends of a touch that goes on: softest N/m, the tangential spring in m; or, with 0 of them, of
    /// none.
    void keepTouch(double softest, double spring = 0) {
        data_.bonds.spring.span()[0] = data_.bonds.spring.span()[1] = {0, spring, 0, softest};
    }
    /// N, on the first after a step from rest at this distance.
    double forceAt(double distance) {
        setDistance(distance);
        for (uint32_t i = 0; i < 2; ++i) now().velocity[i] = {};
        step();
        return force(0);
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

}  // namespace demolish::tests
