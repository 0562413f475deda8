// SPDX-License-Identifier: Apache-2.0
// The bonds that mortar makes where bodies lie against each other (api/mortar.h). Host code in double.
#pragma once
#include <vector>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Two cells of different bodies whose outsides face each other.
struct MortarJoint {
    uint32_t i = 0, j = 0;  ///< i < j, particles of the scene
    double area = 0;        ///< m^2, where they lie against each other
    double stiffness = 0;   ///< N/m, k_N at the trial modulus
};

/// Of all bodies that mortar joins, sorted by (i, j), with their stiffness. From the outsides that are drawn:
/// a body without draw geometry has no joints.
std::vector<MortarJoint> findJoints(const SceneSetup& setup, const SceneTables& tables);

/// Adds bonds at these joints to the rows of the bodies, of which they change nothing: at each end as strong
/// as mortar is beside the material there. They come after all others in the order of bonds.
void appendJoints(const std::vector<MortarJoint>& joints, const SceneSetup& setup, SceneTables& tables);

}  // namespace demolish
