// SPDX-License-Identifier: Apache-2.0
// Groups of bodies of one material in mortar.
#include "sim_cuda/solver/mortar_groups.h"

#include <algorithm>

#include "sim_cuda/solver/body_constants.h"
#include "sim_cuda/solver/mortar_joints.h"

namespace demolish {
namespace {

/// Bonds of two bodies of one kind have the same strength at the same modulus.
bool areOfOneKind(const BodyInstance& a, const BodyInstance& b) {
    return a.material == b.material && a.material.fracture_energy == 0 &&
           thinWallShareOf(*a.body) == thinWallShareOf(*b.body);
}

/// Of each body the first one that is of its kind.
std::vector<uint32_t> kindsOf(const std::vector<BodyInstance>& bodies) {
    std::vector<uint32_t> kind, firsts;
    for (uint32_t b = 0; b < bodies.size(); ++b) {
        const auto known = std::find_if(firsts.begin(), firsts.end(), [&](uint32_t first) {
            return areOfOneKind(bodies[first], bodies[b]);
        });
        kind.push_back(known == firsts.end() ? b : *known);
        if (kind[b] == b) firsts.push_back(b);
    }
    return kind;
}

/// The bodies of one group alone, with their rows.
SceneTables tablesOf(const SceneTables& tables, const MortarGroups& groups, uint32_t group) {
    SceneTables part;
    std::vector<uint32_t> number(tables.mass.size());
    for (uint32_t i = 0; i < number.size(); ++i) {
        if (groups.of_body[tables.owner[i]] != group) continue;
        number[i] = static_cast<uint32_t>(part.mass.size());
        part.mass.push_back(tables.mass[i]);
        part.inertia.push_back(tables.inertia[i]);
    }
    part.row_start.push_back(0);
    for (uint32_t i = 0; i < number.size(); ++i) {
        if (groups.of_body[tables.owner[i]] != group) continue;
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s) {
            part.slots.push_back(tables.slots[s]);
            part.slots.back().other = number[tables.slots[s].other];
        }
        part.row_start.push_back(static_cast<uint32_t>(part.slots.size()));
    }
    return part;
}

void joinVibrations(const SceneSetup& setup, const SceneTables& tables, const MortarGroups& groups,
                    uint32_t group, std::vector<double>& trial_omega) {
    const SceneTables part = tablesOf(tables, groups, group);
    const double omega = highestFrequency(part, 0, static_cast<uint32_t>(part.mass.size()),
                                          shearRatio(setup.bodies[group].material));
    for (size_t b = 0; b < trial_omega.size(); ++b)
        if (groups.of_body[b] == group) trial_omega[b] = omega;
}

}  // namespace

MortarGroups joinBodies(const SceneSetup& setup, SceneTables& tables, std::vector<double>& trial_omega) {
    if (!setup.mortar) return {};
    const std::vector<uint32_t> kind = kindsOf(setup.bodies);
    std::vector<MortarJoint> joints = findJoints(setup, tables, kind);
    MortarGroups groups;
    groups.of_body.assign(tables.bodies, MortarGroups::kAlone);
    for (MortarJoint& joint : joints) {
        const uint32_t a = tables.owner[joint.i], b = tables.owner[joint.j];
        BondGeometry bond;
        bond.area = joint.area;
        bond.length = length(tables.position[joint.j] - tables.position[joint.i]);
        joint.stiffness = stiffnessOf(setup.bodies[a].material, bond, kTrialModulus).normal;
        groups.of_body[a] = groups.of_body[b] = kind[a];
    }
    for (uint32_t b = 0; b < tables.bodies; ++b)  // the group's name is that of a body in it
        if (std::count(groups.of_body.begin(), groups.of_body.end(), b) > 0) groups.of_body[b] = b;
    appendJoints(joints, setup, tables);
    for (uint32_t b = 0; b < tables.bodies; ++b)
        if (groups.of_body[b] == b) joinVibrations(setup, tables, groups, b, trial_omega);
    return groups;
}

void shareConstants(const MortarGroups& groups, SceneTables& tables) {
    for (uint32_t group = 0; group < groups.of_body.size(); ++group) {
        if (groups.of_body[group] != group) continue;
        double radius = 0, strength = 0, stiffness = 0, members = 0;
        for (uint32_t b = 0; b < tables.bodies; ++b) {
            if (groups.of_body[b] != group) continue;
            radius = std::max(radius, tables.body[b].largest_radius);
            strength = std::max(strength, tables.body[b].strength_scale);
            stiffness += tables.body[b].mean_stiffness;
            members += 1;
        }
        for (uint32_t b = 0; b < tables.bodies; ++b) {
            if (groups.of_body[b] != group) continue;
            BodyConstants& constants = tables.body[b];
            constants.largest_radius = radius;
            constants.strength_scale = strength;
            constants.largest_strength = strength / constants.report.strength;
            constants.mean_stiffness = stiffness / members;
        }
    }
}

}  // namespace demolish
