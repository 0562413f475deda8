// SPDX-License-Identifier: Apache-2.0
// Constants of a substep that are the same for all particles, and the law constants of each body.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/data/corners.h"
#include "sim_cuda/data/fragment_velocity.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/physics/touch_law.h"

namespace demolish {

/// Law constants of the bonds of one body (models E.1). Radius and strength come as 16-bit shares of these
/// units.
template <class Real>
struct BodyLaw {
    Real shear_ratio{};    ///< a = k_T / k_N; k_P = 2 a k_B
    Real beta_r{};         ///< s, of (E3)
    Real radius_unit{};    ///< m: a_b = radius_unit * share
    Real strength_unit{};  ///< Pa: s_b sigma_c = strength_unit * share
    FaceLaw<Real> faces;   ///< of its broken bonds
};

/// Of a kick, from its start on.
enum class KickShare : uint32_t { kAll, kFirstHalf };

template <class Real>
struct StepParams : TouchStep<Real> {
    Real drift{};        ///< s, way from the state before to this one: dt unless contact steps change length
    Real carry_time{};   ///< s that carried particles go along their velocity; not always dt
    Vec3<Real> gravity;  ///< m/s^2
    Real velocity_keep{
        1};  ///< share of every velocity kept in a substep; 1 except while settling (models E.4)
    uint32_t leaves_out = 0;  ///< 1: pairs with what the other kind of step moves are no matter of this
                              ///< one: in contact steps, and in substeps that rigid fragments go apart from
    uint32_t breaking = 1;    ///< 0: bonds hold whatever happens (settling)
    KickShare booked = KickShare::kAll;  ///< of the kick, by the ledger
    uint32_t owners = 0;                 ///< bodies + projectile slots: rows of the table of pair laws
    uint32_t in_bodies = 0;              ///< particles of bodies
    uint32_t total = 0;                  ///< with projectile slots
    ColliderSet<Real> colliders;
};

/// Everything that is gathered from in a substep, and what it writes.
template <class Real>
struct SubstepArrays {
    StateIn<Real> in;
    StateOut<Real> out;
    Span<const ParticleConstants<Real>> constants;
    Span<const uint32_t> owner;
    Span<const uint32_t> bond_row, contact_row;
    Span<const Vec4<Real>> rest;
    Span<const uint32_t> neighbour;
    Span<const BodyLaw<Real>> body_laws;  ///< per body
    Span<const PairLaw<Real>> pair_laws;  ///< owners x owners
    Span<const PairLaw<Real>> wall_laws;  ///< owners x colliders
    CornersIn<Real> corners;
    Span<BondLink> link;                                            ///< own slots only
    Span<Vec4<Real>> bond_spring, contact_spring, collider_spring;  ///< own slots only
    Span<Vec4<Real>> ledger;                                        ///< data/ledger.h
    Span<Vec4<Real>> carried;  ///< two a particle: force and torque that a carried one felt in the substeps
                               ///< since the last contact step, added up; none: nothing is carried
    Span<Vec4<Real>> carried_tally;  ///< four a particle, for the ledger: of that, what damps and what rubs
    FragmentVelocities<Real> fragments;
    BondedWork work;
    Span<Vec4<Real>> led_from;  ///< two a particle: velocity and spin before a path changed them since the
                                ///< last step, less those of now; none: nothing is held
};

/// Of what belongs to an owner, against collider c.
template <class Real>
DEM_FN const PairLaw<Real>& wallLaw(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                    uint32_t owner, uint32_t c) {
    return arrays.wall_laws[owner * params.colliders.count + c];
}

}  // namespace demolish
