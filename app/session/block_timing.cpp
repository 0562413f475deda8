// SPDX-License-Identifier: Apache-2.0
// Blocks in three states, each stepped and timed as a whole.
#include "app/session/block_timing.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/solver.h"

namespace demolish {
namespace {

constexpr int kRepeats = 5, kMostBreakingBatches = 40;
constexpr double kFall = -4;  // m/s: shatters the weak block
constexpr double kWeak = 1;   // m/s, critical velocity of the block that shatters; a thousandth: of sand
constexpr double kSand = 1e-6;

SceneSetup setupOf(std::shared_ptr<const BreakableBody> body, BlockState state) {
    const bool falls = state != BlockState::kIntact;
    SceneSetup setup;
    BodyInstance block;
    block.body = std::move(body);
    block.material.name = "stone";
    block.material.density = 2650;
    block.material.tough_cells = state == BlockState::kShattering ? 12 : 0;
    block.material.critical_velocity = state == BlockState::kBroken ? kSand : kWeak;
    block.position = {0, falls ? 0.001 : 1.0, 0};
    block.velocity = {0, falls ? kFall : 0.0, 0};
    setup.bodies.push_back(std::move(block));
    if (state != BlockState::kBroken) setup.params.gravity = {0, 0, 0};
    setup.params.ledger = false;
    return setup;
}

void step(Solver& solver, uint32_t substeps) {
    const StepStatus status = solver.advanceSubsteps(substeps);
    if (status != StepStatus::kOk) throw NumericalError(describe(status));
    solver.synchronize();
}

/// us a substep: the median of some batches.
double microseconds(Solver& solver, uint32_t substeps) {
    using Clock = std::chrono::steady_clock;
    std::array<double, kRepeats> times{};
    for (auto& time : times) {
        const auto begun = Clock::now();
        step(solver, substeps);
        time = std::chrono::duration<double, std::micro>(Clock::now() - begun).count() / substeps;
    }
    std::sort(times.begin(), times.end());
    return times[kRepeats / 2];
}

uint32_t batchSize(bool cuda, size_t particles) {
    if (!cuda) return 20;
    return particles < 100'000 ? 1000 : 200;
}

}  // namespace

BlockTime timeBlock(bool cuda, const std::shared_ptr<const BreakableBody>& body, BlockState state) {
    const SceneSetup setup = setupOf(body, state);
    const auto solver = cuda ? makeCudaSolver(setup) : makeCpuSolver(setup);
    const uint32_t batch = batchSize(cuda, body->particles.size());
    step(*solver, batch);
    if (state == BlockState::kBroken)
        for (int k = 0; k < kMostBreakingBatches && solver->stats().bonds_broken < solver->stats().bonds; ++k)
            step(*solver, batch);
    const double time = microseconds(*solver, batch);
    return {time, solver->stats().bonds, solver->stats().bonds_broken};
}

}  // namespace demolish
