// SPDX-License-Identifier: Apache-2.0
// From a set-up to tables: particles in the world, bond rows, and the softening rule that ties stiffness to
// the time step.
#include "sim_cuda/solver/scene_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <tuple>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/wave_speed.h"
#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/restitution.h"
#include "sim_cuda/physics/softening.h"
#include "sim_cuda/physics/strength.h"
#include "sim_cuda/physics/time_step.h"
#include "sim_cuda/physics/tough_cells.h"
#include "sim_cuda/solver/body_constants.h"
#include "sim_cuda/solver/facing_bodies.h"
#include "sim_cuda/solver/mortar_groups.h"

namespace demolish {
namespace {

Vec3<double> vec(const Double3& a) {
    return {a.x, a.y, a.z};
}

/// m
double finestSpacing(const BreakableBody& body) {
    const std::vector<double>& own = body.cell_spacing;
    return own.empty() ? body.spacing : *std::min_element(own.begin(), own.end());
}

/// Where the corners of each shape begin.
using CornerStarts = std::map<const BreakableBody*, uint32_t>;

/// `contact`: m, the particles' contact radii.
void appendCorners(const BreakableBody& body, const double* contact, CornerStarts& starts,
                   SceneTables& tables) {
    const CellCorners& corners = body.corners;
    const auto [known, is_new] = starts.try_emplace(&body, static_cast<uint32_t>(tables.corner.size()));
    if (is_new)
        for (const Double3& corner : corners.from_seed) tables.corner.push_back(vec(corner));
    if (corners.start.empty()) return tables.corner_row.resize(tables.mass.size());
    const uint32_t first = known->second;
    for (size_t i = 0; i < body.particles.size(); ++i)
        tables.corner_row.push_back({first + corners.start[i], first + corners.start[i + 1],
                                     std::min(body.particles[i].depth, contact[i])});
}

void appendParticles(const BodyInstance& instance, uint32_t number, SceneTables& tables) {
    const BreakableBody& body = *instance.body;
    const Quat<double> q = normalized(
        Quat<double>{instance.rotation.x, instance.rotation.y, instance.rotation.z, instance.rotation.w});
    const std::vector<double> contact = contactRadii(body), floor = floorRadii(body);
    const std::vector<uint32_t> buried = buriedParticles(body);
    tables.buried.insert(tables.buried.end(), buried.begin(), buried.end());
    double mass = 0;
    Vec3<double> centre;
    const size_t first = tables.mass.size();
    for (size_t i = 0; i < body.particles.size(); ++i) {
        const Particle& p = body.particles[i];
        const double m = instance.material.density * p.volume, r = std::cbrt(3 * p.volume / (4 * kPi));
        tables.mass.push_back(m);
        tables.inertia.push_back(0.4 * m * r * r);
        tables.contact_radius.push_back(contact[i]);
        tables.floor_radius.push_back(floor[i]);
        tables.owner.push_back(number);
        tables.rotation.push_back(q);
        tables.position.push_back(vec(instance.position) + rotate(q, vec(p.seed)));
        tables.largest_radius = std::max(tables.largest_radius, contact[i]);
        mass += m;
        centre = axpy(m, tables.position.back(), centre);
    }
    centre = (1 / mass) * centre;
    tables.mass_in_bodies += mass;
    const Vec3<double> spin = vec(instance.angular_velocity);
    for (size_t i = first; i < tables.mass.size(); ++i) {
        tables.spin.push_back(spin);
        tables.velocity.push_back(vec(instance.velocity) + cross(spin, tables.position[i] - centre));
    }
}

/// Of each particle; empty: no tough cells. Those
/// that the body came with, else drawn.
std::vector<uint32_t> toughCells(const BodyInstance& instance, uint64_t seed) {
    const BreakableBody& body = *instance.body;
    if (instance.material.tough_cells == 0 || !body.tough_cell.empty()) return body.tough_cell;
    std::vector<Vec3<double>> seeds;
    seeds.reserve(body.particles.size());
    double volume = 0;
    for (const Particle& p : body.particles) {
        seeds.push_back(vec(p.seed));
        volume += p.volume;
    }
    return toughCellLabels(seeds, volume, instance.material.tough_cells, seed);
}

/// Strength factors of a body's bonds: Weibull
/// scatter, 1/sqrt(a_b) of (13), what is painted, tough cells (models E.3).
std::vector<double> strengthFactors(const BodyInstance& instance, uint64_t seed) {
    const BreakableBody& body = *instance.body;
    std::vector<double> factors(body.bonds.size());
    for (size_t b = 0; b < factors.size(); ++b)
        factors[b] = weibullFactor(instance.material.weibull_modulus, counterHash(seed, 1), b);
    if (instance.material.fracture_energy > 0) {
        const double mean = meanBondRadius(body);
        for (size_t b = 0; b < factors.size(); ++b)
            factors[b] *= std::sqrt(mean / faceBondRadius(body.bonds[b].area));
    }
    for (size_t b = 0; b < body.bond_strength.size(); ++b) factors[b] *= body.bond_strength[b];
    const std::vector<uint32_t> cell = toughCells(instance, counterHash(seed, 2));
    if (cell.empty()) return factors;
    for (size_t b = 0; b < factors.size(); ++b)
        factors[b] *= cell[body.bonds[b].i] == cell[body.bonds[b].j] ? instance.material.tough_factor
                                                                     : body.border_strength;
    return factors;
}

/// Rows of one body at the trial modulus; bond (i,
/// j) goes into both ends' rows, each sorted by the
/// other's id.
void appendBonds(const BodyInstance& instance, uint32_t first, uint64_t seed, SceneTables& tables) {
    const BreakableBody& body = *instance.body;
    const std::vector<double> factors = strengthFactors(instance, seed);
    const uint32_t count = static_cast<uint32_t>(body.particles.size());
    std::vector<uint32_t> fill(count, 0);
    for (const BondGeometry& bond : body.bonds) {
        ++fill[bond.i];
        ++fill[bond.j];
    }
    uint32_t next = static_cast<uint32_t>(tables.slots.size());
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t size = fill[i];
        fill[i] = next;
        next += size;
        tables.row_start.push_back(next);
    }
    tables.slots.resize(next);
    tables.twin.resize(next);
    // Bonds sorted by (i, j): first the slots
    // towards lower ids, then those towards higher
    // ones, each ascending.
    std::vector<uint32_t> place(body.bonds.size());
    for (size_t b = 0; b < body.bonds.size(); ++b) place[b] = fill[body.bonds[b].j]++;
    for (size_t b = 0; b < body.bonds.size(); ++b) {
        const BondGeometry& bond = body.bonds[b];
        const double k = stiffnessOf(instance.material, bond, kTrialModulus).normal,
                     radius = faceBondRadius(bond.area);
        const Vec3<double> rest = bond.length * vec(bond.normal);
        const uint32_t here = fill[bond.i]++, there = place[b];
        tables.slots[here] = {first + bond.j, rest, k, radius, factors[b]};
        tables.slots[there] = {first + bond.i, -rest, k, radius, factors[b]};
        tables.twin[here] = there;
        tables.twin[there] = here;
        tables.slot_of_bond.push_back(here);
    }
}

/// Scales a body's slots from the trial modulus to
/// its own and collects what its laws need.
void finishBody(uint32_t first, uint32_t count, BodyConstants& constants, double spacing,
                SceneTables& tables) {
    const double scale = constants.report.bond_modulus / kTrialModulus;
    const uint32_t begin = tables.row_start[first], end = tables.row_start[first + count];
    double sum = 0;
    for (uint32_t s = begin; s < end; ++s) {
        tables.slots[s].stiffness *= scale;
        sum += tables.slots[s].stiffness;
        constants.largest_radius = std::max(constants.largest_radius, tables.slots[s].radius);
        constants.largest_strength = std::max(constants.largest_strength, tables.slots[s].strength);
    }
    constants.strength_scale = constants.report.strength * constants.largest_strength;
    constants.mean_stiffness = end > begin ? sum / (end - begin) : constants.report.bond_modulus * spacing;
}

/// True when two instances vibrate alike at the
/// trial modulus.
bool vibrateAlike(const BodyInstance& a, const BodyInstance& b) {
    const auto key = [](const Material& m) {
        return std::tuple(m.density, m.poisson_ratio, m.bond_law, m.shear_ratio, m.bond_ratio);
    };
    return a.body == b.body && key(a.material) == key(b.material);
}

/// rad/s, at the trial modulus, of the last body of
/// the tables; `known` holds those of the bodies
/// before.
double trialFrequency(const SceneSetup& setup, const SceneTables& tables, uint32_t first,
                      const std::vector<double>& known) {
    const size_t number = known.size();
    for (size_t b = 0; b < number; ++b)
        if (vibrateAlike(setup.bodies[b], setup.bodies[number])) return known[b];
    const auto count = static_cast<uint32_t>(tables.mass.size()) - first;
    return highestFrequency(tables, first, count, shearRatio(setup.bodies[number].material));
}

uint32_t substepsWithin(double frame_time, double dt) {
    return static_cast<uint32_t>(std::max(1.0, std::ceil(frame_time / dt - 1e-9)));
}

double softenedStep(const SolverParams& params) {
    return 1.0 / 60 / params.substeps;
}

/// s: 1/60 s over the substeps asked for, or what
/// the stiffest body allows.
double chooseTimeStep(const SceneSetup& setup, const std::vector<double>& trial_omega) {
    const SolverParams& params = setup.params;
    if (params.soften) return softenedStep(params);
    double dt = params.frame_time;
    for (size_t b = 0; b < setup.bodies.size(); ++b) {
        if (!(trial_omega[b] > 0)) continue;
        const BodyConstants constants = bodyConstants(setup.bodies[b], params, trial_omega[b], dt);
        dt = std::min(dt, stableStep(constants.report.highest_frequency,
                                     setup.bodies[b].material.damping_ratio, params.step_safety));
    }
    return dt;
}

/// 1/s^2. Bonds of a step safety below the usual
/// one are softer than their step admits; contacts
/// stay as soft in proportion, or a ball would grow
/// harder by nothing but finer steps. Never more
/// than the step admits.
double contactCap(double step_safety, double dt) {
    constexpr double kUsualSafety = SolverParams{}.step_safety;
    const double share = std::min(1.0, step_safety / kUsualSafety);
    return kContactStiffnessShare / (dt * dt) * (share * share);
}

void report(const ProgressCallback& progress, double fraction, const char* stage) {
    if (progress && !progress(fraction, stage)) throw Cancelled();
}

}  // namespace

SceneTables buildSceneTables(const SceneSetup& setup, const ProgressCallback& progress) {
    checkSetup(setup);
    SceneTables tables;
    tables.bodies = static_cast<uint32_t>(setup.bodies.size());
    tables.row_start.push_back(0);
    std::vector<uint32_t> first{0};
    std::vector<double> omega;
    CornerStarts corner_starts;
    tables.spacing = finestSpacing(*setup.bodies[0].body);
    for (uint32_t b = 0; b < tables.bodies; ++b) {
        report(progress, static_cast<double>(b) / tables.bodies, "Finding the stable time step");
        const BodyInstance& instance = setup.bodies[b];
        appendParticles(instance, b, tables);
        appendCorners(*instance.body, &tables.contact_radius[first[b]], corner_starts, tables);
        appendBonds(instance, first[b], counterHash(setup.params.seed, b), tables);
        first.push_back(static_cast<uint32_t>(tables.mass.size()));
        omega.push_back(trialFrequency(setup, tables, first[b], omega));
        tables.spacing = std::min(tables.spacing, finestSpacing(*instance.body));
    }
    keepBodiesApart(tables);
    holdAnchored(setup, tables);
    tables.counts = {first.back(), first.back() + kMaxProjectiles};
    tables.row_start.resize(tables.counts.total + 1, tables.row_start.back());
    const MortarGroups groups = joinBodies(setup, tables, omega);
    const double dt = chooseTimeStep(setup, omega);
    tables.substeps = substepsWithin(setup.params.frame_time, dt);
    tables.time_step = setup.params.frame_time / tables.substeps;
    tables.contact_cap = contactCap(setup.params.step_safety, tables.time_step);
    for (uint32_t b = 0; b < tables.bodies; ++b) {
        tables.body.push_back(bodyConstants(setup.bodies[b], setup.params, omega[b], tables.time_step));
        finishBody(first[b], first[b + 1] - first[b], tables.body[b], setup.bodies[b].body->spacing, tables);
    }
    shareConstants(groups, tables);
    letBodiesFace(setup, tables);
    report(progress, 1, "Finding the stable time step");
    return tables;
}

uint32_t slowedSubsteps(uint32_t substeps, double time_scale) {
    return static_cast<uint32_t>(std::max(1.0, std::round(substeps * time_scale)));
}

uint32_t substepsOfFrame(const SolverParams& params, double time_scale) {
    return slowedSubsteps(substepsWithin(params.frame_time, softenedStep(params)), time_scale);
}

double softenedWaveSpeed(const BreakableBody& body, const Material& material, uint32_t substeps,
                         double step_safety) {
    BodyInstance instance;
    instance.body = std::shared_ptr<const BreakableBody>(std::shared_ptr<void>(),
                                                         &body);  // owns nothing
    instance.material = material;
    SceneTables tables;
    tables.row_start.push_back(0);
    appendParticles(instance, 0, tables);
    appendBonds(instance, 0, 0, tables);
    const double omega =
        highestFrequency(tables, 0, static_cast<uint32_t>(tables.mass.size()), shearRatio(instance.material));
    if (!(omega > 0)) return 0;
    SolverParams params;
    params.step_safety = step_safety;
    return bodyConstants(instance, params, omega, 1.0 / 60 / substeps).report.wave_speed;
}

}  // namespace demolish
