// SPDX-License-Identifier: Apache-2.0
// Bodies that mortar joins: both ends of a joint must come to the same numbers, and the whole vibrates as
// one.
#pragma once
#include <vector>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Of each body its group, which mortar joins among each other, or kAlone.
struct MortarGroups {
    static constexpr uint32_t kAlone = 0xffffffffu;
    std::vector<uint32_t> of_body;
};

/// Finds the joints and adds their bonds to the rows. trial_omega: rad/s of each body, at the trial modulus;
/// those of a group get that of the group as it is joined.
MortarGroups joinBodies(const SceneSetup& setup, SceneTables& tables, std::vector<double>& trial_omega);

/// Once the constants of the bodies are known: those of a group get the same ones.
void shareConstants(const MortarGroups& groups, SceneTables& tables);

}  // namespace demolish
