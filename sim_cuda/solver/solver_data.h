// SPDX-License-Identifier: Apache-2.0
// All that lives on the device: made once from the scene tables; the changing part can be set aside and put
// back.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/kernels/own_particle.h"
#include "sim_cuda/kernels/start_velocities.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

template <class Real>
Vec3<Real> toReal(const Vec3<double>& a) {
    return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
}

/// One particle's state as it is laid out: position split into a high and a low part.
template <class Real>
LoadedState<Real> packState(const Vec3<double>& position, const Quat<double>& rotation,
                            const Vec3<double>& velocity, const Vec3<double>& spin) {
    const Vec3<Real> high = toReal<Real>(position);
    const Vec3<Real> low = toReal<Real>(position - Vec3<double>{high.x, high.y, high.z});
    return {withW(high, low.x),
            {static_cast<Real>(rotation.x), static_cast<Real>(rotation.y), static_cast<Real>(rotation.z),
             static_cast<Real>(rotation.w)},
            withW(toReal<Real>(velocity), low.y),
            withW(toReal<Real>(spin), low.z)};
}

template <class Backend, class Real>
struct SolverData {
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    ParticleArrays<Backend, Real> particles;
    Buffer<ParticleConstants<Real>> masses;  ///< of particles in bodies, where some are held: their own ones
    BondArrays<Backend, Real> bonds;
    Buffer<Vec4<Real>> collider_spring, ledger;
    Buffer<Vec4<Real>> led_from;         ///< as in SubstepArrays
    Buffer<Vec4<Real>> fragment_start;   ///< as in FragmentVelocities
    Buffer<uint64_t> fragment_added[2];  ///< likewise
    Span<const uint32_t> label;          ///< likewise
    Buffer<CornerRow<Real>> corner_row;
    Buffer<Vec4<Real>> corner;
    Buffer<BodyLaw<Real>> body_laws;
    Buffer<PairLaw<Real>> pair_laws, wall_laws;
    uint32_t current = 0;  ///< which of the two states is the present one
    BondedWork work;       ///< which particles a substep moves
    Span<const ParticleConstants<Real>>
        constants_in_substeps;                ///< where rigid fragments move too; none: particles.constants
    Span<Vec4<Real>> carried, carried_tally;  ///< as in SubstepArrays

    SolverData(Backend& backend, const SceneTables& tables, uint32_t colliders);

    void uploadLaws(Backend& backend, const LawTables& laws);
    /// Constants of the particles in bodies with their true masses, whether they are held or not.
    Span<const ParticleConstants<Real>> ownMasses() const {
        return masses.size() > 0 ? masses.view() : particles.constants.view();
    }
    /// Particle i of the present state anew. Waits.
    void put(Backend& backend, uint32_t i, const LoadedState<Real>& state,
             const ParticleConstants<Real>& constants);
    /// Views for a substep from the present state into the other one.
    SubstepArrays<Real> arrays(ContactArrays<Backend, Real>& contacts);
    /// The same where carried particles may be among those moved.
    SubstepArrays<Real> arraysInSubsteps(ContactArrays<Backend, Real>& contacts);

    /// poses: of the present state. fall: as in StartVelocities. Everything is moved with its bonds, unless
    /// the caller says otherwise.
    StartVelocities<Real> startVelocities(const FragmentRows& rows, Span<const PoseSums> poses,
                                          const HoldsIn& holds, const Vec3<double>& fall) {
        return {rows,
                label,
                poses,
                holds,
                fall,
                fragment_start.span(),
                {fragment_added[0].span(), fragment_added[1].span()},
                {}};
    }

  private:
    void uploadParticles(Backend& backend, const SceneTables& tables);
    void uploadBonds(Backend& backend, const SceneTables& tables);
    void uploadCorners(Backend& backend, const SceneTables& tables);
};

template <class Backend, class Real>
SolverData<Backend, Real>::SolverData(Backend& backend, const SceneTables& tables, uint32_t colliders) {
    uploadParticles(backend, tables);
    uploadBonds(backend, tables);
    uploadCorners(backend, tables);
    const uint32_t total = tables.counts.total;
    collider_spring = backend.template allocate<Vec4<Real>>(std::max<size_t>(1, size_t{colliders} * total));
    ledger = backend.template allocate<Vec4<Real>>(total);
    if (!tables.anchor.empty()) led_from = backend.template allocate<Vec4<Real>>(2 * size_t{total});
    fragment_start = backend.template allocate<Vec4<Real>>(total);
    for (Buffer<uint64_t>& added : fragment_added)
        added = backend.template allocate<uint64_t>(3 * size_t{total});
}

template <class Backend, class Real>
void SolverData<Backend, Real>::uploadParticles(Backend& backend, const SceneTables& tables) {
    particles.counts = tables.counts;
    const uint32_t total = tables.counts.total, in_bodies = tables.counts.in_bodies;
    std::vector<Vec4<Real>> position(total), rotation(total, {Real(0), Real(0), Real(0), Real(1)}),
        velocity(total), spin(total);
    std::vector<ParticleConstants<Real>> constants(total);
    std::vector<uint32_t> owner = tables.owner;
    for (uint32_t i = 0; i < in_bodies; ++i) {
        const LoadedState<Real> state =
            packState<Real>(tables.position[i], tables.rotation[i], tables.velocity[i], tables.spin[i]);
        position[i] = state.position;
        rotation[i] = state.rotation;
        velocity[i] = state.velocity;
        spin[i] = state.spin;
        constants[i] = {static_cast<Real>(1 / tables.mass[i]), static_cast<Real>(1 / tables.inertia[i]),
                        static_cast<Real>(tables.contact_radius[i]),
                        static_cast<Real>(tables.floor_radius[i])};
    }
    if (!tables.anchor.empty()) {
        masses = backend.uploaded(constants);
        backend.synchronize();
        for (uint32_t i = 0; i < in_bodies; ++i)
            if (tables.anchor[i] != SceneTables::kNoAnchor)
                constants[i] = ParticleConstants<Real>::held(static_cast<Real>(tables.contact_radius[i]));
    }
    for (uint32_t p = 0; p < kMaxProjectiles; ++p) owner.push_back(tables.bodies + p);
    for (int which = 0; which < 2; ++which) {
        particles.position[which] = backend.uploaded(position);
        particles.rotation[which] = backend.uploaded(rotation);
        particles.velocity[which] = backend.uploaded(velocity);
        particles.spin[which] = backend.uploaded(spin);
    }
    particles.constants = backend.uploaded(constants);
    particles.owner = backend.uploaded(owner);
}

template <class Backend, class Real>
void SolverData<Backend, Real>::uploadBonds(Backend& backend, const SceneTables& tables) {
    const size_t slots = tables.slots.size();
    std::vector<BondLink> link(slots);
    std::vector<Vec4<Real>> rest(slots);
    const auto share = [](double value, double largest) {
        return static_cast<uint32_t>(std::clamp(std::round(65535 * value / largest), 1.0, 65535.0));
    };
    for (uint32_t i = 0; i < tables.counts.in_bodies; ++i) {
        const BodyConstants& body = tables.body[tables.owner[i]];
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s) {
            const BondSlot& slot = tables.slots[s];
            link[s] = {linkWord(slot.other, slot.is_bond ? PairState::kBonded : PairState::kFacing), 0};
            if (slot.is_bond)
                link[s].grade = share(slot.radius, body.largest_radius) |
                                share(slot.strength, body.largest_strength) << 16;
            rest[s] = withW(toReal<Real>(slot.rest), static_cast<Real>(slot.stiffness));
        }
    }
    bonds.count = static_cast<uint32_t>(tables.slot_of_bond.size());
    bonds.facing = static_cast<uint32_t>(slots) - 2 * bonds.count;
    bonds.row_start = backend.uploaded(tables.row_start);
    bonds.link = backend.uploaded(link);
    bonds.rest = backend.uploaded(rest);
    bonds.spring = backend.template allocate<Vec4<Real>>(slots);
    bonds.slot_of_bond = backend.uploaded(tables.slot_of_bond);
    bonds.twin = backend.uploaded(tables.twin);
}

template <class Backend, class Real>
void SolverData<Backend, Real>::uploadCorners(Backend& backend, const SceneTables& tables) {
    std::vector<CornerRow<Real>> rows(tables.counts.total);
    std::transform(tables.corner_row.begin(), tables.corner_row.end(), rows.begin(),
                   [](const CornerRow<double>& row) {
                       return CornerRow<Real>{row.first, row.last, static_cast<Real>(row.inner_radius)};
                   });
    std::vector<Vec4<Real>> corners(std::max<size_t>(1, tables.corner.size()));
    std::transform(tables.corner.begin(), tables.corner.end(), corners.begin(),
                   [](const Vec3<double>& from_seed) { return withW(toReal<Real>(from_seed), Real(0)); });
    corner_row = backend.uploaded(rows);
    corner = backend.uploaded(corners);
    backend.synchronize();  // the host copies go out of scope
}

template <class Backend, class Real>
void SolverData<Backend, Real>::uploadLaws(Backend& backend, const LawTables& laws) {
    const auto real = [](double value) { return static_cast<Real>(value); };
    std::vector<BodyLaw<Real>> body;
    for (const BodyLaw<double>& law : laws.body)
        body.push_back({real(law.shear_ratio),
                        real(law.beta_r),
                        real(law.radius_unit),
                        real(law.strength_unit),
                        {real(law.faces.friction), real(law.faces.rolling), real(law.faces.adhesion)}});
    const auto pairs = [&](const std::vector<PairLaw<double>>& from) {
        std::vector<PairLaw<Real>> to;
        for (const PairLaw<double>& law : from)
            to.push_back({real(law.stiffness), real(law.damping), real(law.friction), real(law.rolling),
                          real(law.adhesion), real(law.modulus), real(law.shear_modulus), real(law.gentle)});
        return to;
    };
    backend.synchronize();
    body_laws = backend.uploaded(body);
    pair_laws = backend.uploaded(pairs(laws.pair));
    wall_laws = backend.uploaded(pairs(laws.wall));
}

template <class Backend, class Real>
void SolverData<Backend, Real>::put(Backend& backend, uint32_t i, const LoadedState<Real>& state,
                                    const ParticleConstants<Real>& constants) {
    const StateOut<Real> now = particles.out(current);
    backend.upload(now.position.part(i, 1), &state.position, 1);
    backend.upload(now.rotation.part(i, 1), &state.rotation, 1);
    backend.upload(now.velocity.part(i, 1), &state.velocity, 1);
    backend.upload(now.spin.part(i, 1), &state.spin, 1);
    backend.upload(particles.constants.span().part(i, 1), &constants, 1);
    backend.synchronize();
}

template <class Backend, class Real>
SubstepArrays<Real> SolverData<Backend, Real>::arrays(ContactArrays<Backend, Real>& contacts) {
    return {
        particles.in(current),
        particles.out(1 - current),
        particles.constants.view(),
        particles.owner.view(),
        bonds.row_start.view(),
        contacts.row_start.view(),
        bonds.rest.view(),
        contacts.neighbour.view(),
        body_laws.view(),
        pair_laws.view(),
        wall_laws.view(),
        {corner_row.view(), corner.view()},
        bonds.link.span(),
        bonds.spring.span(),
        contacts.spring.span(),
        collider_spring.span(),
        ledger.span(),
        carried,
        carried_tally,
        {label, fragment_start.view(), fragment_added[1 - current].view(), fragment_added[current].span()},
        work,
        led_from.span()};
}

template <class Backend, class Real>
SubstepArrays<Real> SolverData<Backend, Real>::arraysInSubsteps(ContactArrays<Backend, Real>& contacts) {
    SubstepArrays<Real> views = arrays(contacts);
    if (constants_in_substeps.data != nullptr) views.constants = constants_in_substeps;
    return views;
}

}  // namespace demolish
