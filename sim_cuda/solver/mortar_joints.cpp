// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/mortar_joints.h"

#include <algorithm>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/solver/body_constants.h"
#include "sim_cuda/solver/facing_cells.h"
#include "sim_cuda/solver/pair_records.h"

namespace demolish {
namespace {

/// Strength by (13) hangs on the modulus, which bodies in mortar share.
bool mayJoin(const BodyInstance& a, const BodyInstance& b) {
    return a.in_mortar && b.in_mortar && a.rotation == b.rotation && a.material.fracture_energy == 0 &&
           b.material.fracture_energy == 0;
}

/// N/m, k_N at the trial modulus: that of the softer material.
double stiffnessAt(const MortarJoint& joint, const SceneSetup& setup, const SceneTables& tables) {
    BondGeometry bond;
    bond.area = joint.area;
    bond.length = length(tables.position[joint.j] - tables.position[joint.i]);
    const auto of = [&](uint32_t end) {
        return stiffnessOf(setup.bodies[tables.owner[end]].material, bond, kTrialModulus).normal;
    };
    return std::min(of(joint.i), of(joint.j));
}

}  // namespace

std::vector<MortarJoint> findJoints(const SceneSetup& setup, const SceneTables& tables) {
    const auto gap = [&](uint32_t a, uint32_t b) {
        return mayJoin(setup.bodies[a], setup.bodies[b]) ? setup.mortar->joint : -1.0;
    };
    std::vector<MortarJoint> joints;
    for (const FacingCells& cells : facingCells(setup, tables, gap)) {
        joints.push_back({cells.i, cells.j, cells.area, 0});
        joints.back().stiffness = stiffnessAt(joints.back(), setup, tables);
    }
    return joints;
}

void appendJoints(const std::vector<MortarJoint>& joints, const SceneSetup& setup, SceneTables& tables) {
    std::vector<PairRecord> records;
    for (const auto& [i, j, area, stiffness] : joints) {
        const auto strength = [&](uint32_t end) {
            return setup.mortar->tensile_strength / setup.bodies[tables.owner[end]].material.tensile_strength;
        };
        const Vec3<double> rest =
            rotate(conjugate(tables.rotation[i]), tables.position[j] - tables.position[i]);
        const double radius = faceBondRadius(area);
        records.push_back(
            {i, j, {j, rest, stiffness, radius, strength(i)}, {i, -rest, stiffness, radius, strength(j)}});
    }
    appendRecords(records, tables);
}

}  // namespace demolish
