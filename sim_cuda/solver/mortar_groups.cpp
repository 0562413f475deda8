// SPDX-License-Identifier: Apache-2.0
// Groups of bodies in mortar, of one material or of several.
#include "sim_cuda/solver/mortar_groups.h"

#include <algorithm>
#include <numeric>

#include "sim_cuda/solver/body_constants.h"
#include "sim_cuda/solver/mortar_joints.h"

namespace demolish {
namespace {

/// Of a group the strongest bond counts as at most so many times as strong as the weakest body: strengths are
/// 16-bit shares of the group's largest, and a joint must keep its digits.
constexpr double kMostUnlike = 100;

uint32_t rootOf(const std::vector<uint32_t>& of_body, uint32_t body) {
    while (of_body[body] != body) body = of_body[body];
    return body;
}

/// Bodies that joints connect, through others as well, are one group, named after its first body.
MortarGroups groupsOf(const std::vector<MortarJoint>& joints, const SceneTables& tables) {
    std::vector<uint32_t> root(tables.bodies);
    std::iota(root.begin(), root.end(), 0u);
    std::vector<bool> is_joined(tables.bodies, false);
    for (const MortarJoint& joint : joints) {
        const uint32_t a = tables.owner[joint.i], b = tables.owner[joint.j];
        is_joined[a] = is_joined[b] = true;
        const uint32_t of_a = rootOf(root, a), of_b = rootOf(root, b);
        root[std::max(of_a, of_b)] = std::min(of_a, of_b);
    }
    MortarGroups groups;
    for (uint32_t b = 0; b < tables.bodies; ++b)
        groups.of_body.push_back(is_joined[b] ? rootOf(root, b) : MortarGroups::kAlone);
    return groups;
}

std::vector<uint32_t> membersOf(const MortarGroups& groups, uint32_t group) {
    std::vector<uint32_t> members;
    for (uint32_t b = 0; b < groups.of_body.size(); ++b)
        if (groups.of_body[b] == group) members.push_back(b);
    return members;
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
    const std::vector<uint32_t> members = membersOf(groups, group);
    double shear = 0;
    for (const uint32_t b : members) shear = std::max(shear, shearRatio(setup.bodies[b].material));
    const double omega = highestFrequency(part, 0, static_cast<uint32_t>(part.mass.size()), shear);
    for (const uint32_t b : members) trial_omega[b] = omega;
}

/// What each end of a bond asks its own body for is the same all over the group: the stiffest in shear, the
/// least damped, the smoothest of them.
void shareLaws(const std::vector<uint32_t>& members, SceneTables& tables) {
    BodyConstants all = tables.body[members.front()];
    double stiffness = 0, weakest = all.report.strength;
    for (const uint32_t b : members) {
        const BodyConstants& own = tables.body[b];
        all.largest_radius = std::max(all.largest_radius, own.largest_radius);
        all.strength_scale = std::max(all.strength_scale, own.strength_scale);
        weakest = std::min(weakest, own.report.strength);
        all.shear_ratio = std::max(all.shear_ratio, own.shear_ratio);
        all.beta_r = std::min(all.beta_r, own.beta_r);
        all.faces = {std::min(all.faces.friction, own.faces.friction),
                     std::min(all.faces.rolling, own.faces.rolling),
                     std::min(all.faces.adhesion, own.faces.adhesion)};
        stiffness += own.mean_stiffness;
    }
    all.mean_stiffness = stiffness / static_cast<double>(members.size());
    all.strength_scale = std::min(all.strength_scale, kMostUnlike * weakest);
    for (const uint32_t b : members) {
        all.report = tables.body[b].report;
        all.largest_strength = 1;
        tables.body[b] = all;
    }
}

/// Strengths become shares of the group's unit.
void shareUnits(const MortarGroups& groups, SceneTables& tables) {
    for (uint32_t i = 0; i < tables.counts.in_bodies; ++i) {
        const uint32_t b = tables.owner[i];
        if (groups.of_body[b] == MortarGroups::kAlone) continue;
        const double share = tables.body[b].report.strength / tables.body[b].strength_scale;
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s)
            tables.slots[s].strength *= share;
    }
}

/// Both slots of a joint hold the same numbers: those of the softer and of the weaker end.
void shareJoints(SceneTables& tables) {
    for (uint32_t i = 0; i < tables.counts.in_bodies; ++i)
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s) {
            BondSlot &here = tables.slots[s], &there = tables.slots[tables.twin[s]];
            if (tables.owner[i] == tables.owner[here.other]) continue;
            here.stiffness = there.stiffness = std::min(here.stiffness, there.stiffness);
            here.strength = there.strength = std::min(here.strength, there.strength);
        }
}

}  // namespace

MortarGroups joinBodies(const SceneSetup& setup, SceneTables& tables, std::vector<double>& trial_omega) {
    if (!setup.mortar) return {};
    const std::vector<MortarJoint> joints = findJoints(setup, tables);
    const MortarGroups groups = groupsOf(joints, tables);
    appendJoints(joints, setup, tables);
    for (uint32_t b = 0; b < tables.bodies; ++b)
        if (groups.of_body[b] == b) joinVibrations(setup, tables, groups, b, trial_omega);
    return groups;
}

void shareConstants(const MortarGroups& groups, SceneTables& tables) {
    for (uint32_t group = 0; group < groups.of_body.size(); ++group)
        if (groups.of_body[group] == group) shareLaws(membersOf(groups, group), tables);
    if (groups.of_body.empty()) return;
    shareUnits(groups, tables);
    shareJoints(tables);
}

}  // namespace demolish
