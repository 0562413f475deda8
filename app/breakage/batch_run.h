// SPDX-License-Identifier: Apache-2.0
// One item of a plan: its specimens fall on the wall in one simulation, side by side and out of each other's
// reach.
#pragma once
#include <vector>

#include "app/breakage/plan.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

struct ItemResult {
    std::vector<Outcome> outcomes;  ///< in the order of the item's runs
    double time_step = 0;           ///< s
    uint64_t substeps = 0;
    uint64_t particles = 0, bonds = 0, bonds_broken = 0;
    EnergyLedger energy;       ///< J, of all specimens, at the end
    double impact_energy = 0;  ///< J, kinetic at the beginning
};

/// The scene of one item; bodies in the order of the runs. All runs are of the same experiment.
SceneSetup sceneOf(const BreakagePlan& plan, const std::vector<BreakageRun>& runs,
                   const ProgressCallback& progress = {});

/// Throws NumericalError when the simulation becomes unstable, Cancelled, DeviceError.
ItemResult runItem(const BreakagePlan& plan, const std::vector<BreakageRun>& runs, bool on_gpu,
                   const ProgressCallback& progress = {});

}  // namespace demolish
