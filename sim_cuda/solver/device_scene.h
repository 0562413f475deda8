// SPDX-License-Identifier: Apache-2.0
// What is simulated: the scene as it was set up, and its state on the device. The parts of the solver
// (frame_loop.h, frame_exporter.h, energy_measure.h ...) work on it; it does nothing by itself.
#pragma once
#include <vector>

#include "sim_cuda/kernels/paths_now.h"
#include "sim_cuda/patterns/piece_release.h"
#include "sim_cuda/solver/fragments.h"
#include "sim_cuda/solver/held_particles.h"
#include "sim_cuda/solver/neighbour_lists.h"
#include "sim_cuda/solver/projectiles.h"
#include "sim_cuda/solver/regimes.h"
#include "sim_cuda/solver/solver_data.h"
#include "sim_cuda/solver/way_back.h"

namespace demolish {

template <class Real>
StepParams<Real> makeStepParams(const SolverParams& from, const SceneTables& tables,
                                Span<const float> mesh_steps = {}) {
    StepParams<Real> params;
    params.dt = params.drift = params.carry_time = static_cast<Real>(tables.time_step);
    params.gravity = toReal<Real>({from.gravity.x, from.gravity.y, from.gravity.z});
    params.stiffness_cap = static_cast<Real>(tables.contact_cap);
    params.hertz = from.contact_law == ContactLaw::kHertz ? 1 : 0;
    params.owners = tables.owners();
    params.in_bodies = tables.counts.in_bodies;
    params.total = tables.counts.total;
    params.colliders = makeColliderSet<Real>(from.colliders, mesh_steps);
    return params;
}

template <class Backend, class Real>
struct DeviceScene {
    SceneSetup setup;  ///< setup.params.ledger: whether energy is booked now
    SceneTables tables;
    Backend backend;
    typename Backend::template Buffer<float> mesh_steps;  ///< of colliders
    SolverData<Backend, Real> data;
    NeighbourLists<Backend, Real> lists;
    Regimes<Backend, Real> regimes;
    Fragments<Backend, Real> fragments;
    PieceRelease<Backend, Real> release;
    HeldParticles<Backend, Real> held;
    StepParams<Real> params;  ///< of a substep
    uint64_t substeps = 0;    ///< done since the start

    /// Throws UsageError on values out of range, Cancelled when the callback says so.
    DeviceScene(const SceneSetup& from, const ProgressCallback& progress)
        : setup(from),
          tables(buildSceneTables(from, progress)),
          mesh_steps(backend.uploaded(meshSteps(from.params.colliders))),
          data(backend, tables, static_cast<uint32_t>(from.params.colliders.size())),
          lists(backend, tables.counts, tables.largest_radius),
          regimes(backend, from, tables),
          fragments(backend, tables.counts, from),
          release(backend, from, tables.owners()),
          held(backend, from, tables),
          params(makeStepParams<Real>(from.params, tables, mesh_steps.view())) {
        data.label = fragments.clusters.fragment();
        uploadLaws(from.projectiles);
        lists.setBuried(tables.buried);
    }

    double time() const { return static_cast<double>(substeps) * tables.time_step; }  ///< s
    StateIn<Real> state() const { return data.particles.in(data.current); }
    /// Views for a substep from the present state into the other one.
    SubstepArrays<Real> arrays() { return data.arrays(lists.contacts()); }

    /// `elapsed` s after the contact lists were built, seen as far as `ahead` s on.
    PathsNow<Real> pathsNow(double elapsed, double ahead) const {
        const auto& contacts = lists.contacts();
        return {state(), contacts.paths(), static_cast<Real>(elapsed), static_cast<Real>(ahead),
                lists.enclosures(data.bonds.in())};
    }

    /// Which fragments are held, for decisions in the next `seconds`.
    void markHolds(double seconds) {
        if (!held.on()) return;
        held.mark(fragments.clusters.fragment(), time(), time() + seconds);
        regimes.noteHolds(held.holds());
    }

    /// A frame of `seconds` starts in which everything is moved with its bonds.
    void startBonded(double seconds) {
        markHolds(seconds);
        backend.forEach(tables.counts.in_bodies,
                        data.startVelocities(fragments.clusters.rows(), fragments.motion.poses(),
                                             held.on() ? held.holds() : HoldsIn{},
                                             0.5 * seconds * asDouble(params.gravity)),
                        "start velocities");
    }

    /// For `release`, with good contact lists. soon: s until the next decision at the latest.
    HardTouches<Real> hardTouches(double soon) {
        const auto& clusters = fragments.clusters;
        const MeetingsIn<Real> meetings = regimes.meetingsOf(data, lists, clusters, soon);
        return {HitRules<Real>{meetings, clusters.rows(), regimes.regime(), release.laws(), 1, held.holds()},
                params.colliders, params.gravity};
    }

    void uploadLaws(const std::vector<Projectile>& projectiles) {
        data.uploadLaws(backend, buildLawTables(setup, tables, projectiles));
    }
    /// The projectile where it touches nothing (way_back.h); the state must be complete. Waits.
    Projectile setBack(const Projectile& shot);
    /// Projectile `slot` takes part from now on.
    void place(uint32_t slot, const Projectile& shot) {
        const Double3 x = shot.position, v = shot.velocity;
        const double mass = projectileMass(shot), inertia = 0.4 * mass * shot.radius * shot.radius;
        data.put(backend, tables.counts.in_bodies + slot,
                 packState<Real>({x.x, x.y, x.z}, {}, {v.x, v.y, v.z}, {}),
                 {static_cast<Real>(1 / mass), static_cast<Real>(1 / inertia), static_cast<Real>(shot.radius),
                  static_cast<Real>(shot.radius)});
    }
};

template <class Backend, class Real>
Projectile DeviceScene<Backend, Real>::setBack(const Projectile& shot) {
    const StateIn<Real> now = state();
    const auto position = backend.downloaded(now.position);
    const auto constants = backend.downloaded(data.particles.constants.view());
    std::vector<Ball> others;
    for (uint32_t i = 0; i < tables.counts.total; ++i)
        if (constants[i].takesPart())
            others.push_back({inDouble(xyz(position[i])), double(constants[i].contact_radius)});
    return placedFree(shot, others, setup.params.colliders);
}

}  // namespace demolish
