// SPDX-License-Identifier: Apache-2.0
// Energies and momenta of one moment, a particle's share at a time, in double. Pairs belong to the lower id.
#pragma once
#include "sim_cuda/kernels/collider_contact.h"

namespace demolish {

struct MechanicalSums {
    double kinetic = 0, elastic = 0, potential = 0;  ///< J
    double damping = 0, friction = 0, fracture = 0;  ///< J, of the kick up to this moment
    double held = 0;                                 ///< J, likewise: work of what holds particles
    Vec3<double> linear, angular;                    ///< kg m/s; kg m^2/s about the origin

    DEM_FN void operator+=(const MechanicalSums& other) {
        kinetic += other.kinetic;
        elastic += other.elastic;
        potential += other.potential;
        damping += other.damping;
        friction += other.friction;
        fracture += other.fracture;
        held += other.held;
        linear = linear + other.linear;
        angular = angular + other.angular;
    }
};

template <class Real>
DEM_FN Vec3<double> inDouble(const Vec3<Real>& a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

/// What is pressed on a collider: how much sets itself against it is in the stiffness that the touch keeps.
/// Contact steps find it from the whole fragment, and it may be more than a particle alone could bear.
template <class Real>
struct PressesAsKept {
    static constexpr StepKind kStep = StepKind::kSubstep;
    static constexpr double kUnboundedly = 1e-20;  ///< 1/kg
    TurnsAlone<Real> alone;
    DEM_FN SeenCell<Real> cell(const StepParams<Real>& params, const OwnParticle<Real>& own) const {
        return alone.cell(params, own);
    }
    DEM_FN Turning<Real> operator()(const OwnParticle<Real>&, const Pressed<Real>&) const {
        constexpr Real kLeast = kUnboundedly;
        return {kLeast, kLeast, kLeast, kLeast, Real(0), Real(0)};
    }
};

/// `next` is the state one substep later: kinetic energy is half the mass times the velocities before and
/// after the kick, which leapfrog keeps together with that of the springs to the last joule (B.1). So the
/// springs are those after the kick, and the ledger holds what its first half dissipates. What sleeps feels
/// no kick, whatever still presses on it; of what is rigid a dry contact step has left the kick (KickRigid).
template <class Real>
struct MeasureEnergy {
    SubstepArrays<Real> arrays;  ///< only read
    StateIn<Real> next;
    StepParams<Real> params;
    Vec3<double> gravity;                ///< m/s^2
    Span<const uint32_t> label, regime;  ///< of fragments; none: nothing sleeps or is rigid
    Span<const BodyMemory> memory;       ///< of rigid bodies, per slot
    bool lets_go = false;  ///< of contacts, what they lose if their force ends with the last kick

    DEM_FN MechanicalSums operator()(uint32_t i) const {
        MechanicalSums sums;
        const OwnParticle<Real> own = loadOwn(arrays, i);
        if (!own.constants.takesPart()) return sums;
        const bool counts = isMoved(i, Regime::kBonded) || isMoved(i, Regime::kRigid);
        Vec4<Real> booked = counts ? arrays.ledger[i] : Vec4<Real>{};
        sums.damping = static_cast<double>(bookedDamping(booked));
        sums.friction = static_cast<double>(bookedFriction(booked));
        sums.fracture = static_cast<double>(bookedFracture(booked));
        sums.held = static_cast<double>(bookedWork(booked));
        sums.elastic = elasticEnergy(own);
        if (own.constants.isHeld()) return sums;
        const double mass = 1.0 / static_cast<double>(own.constants.inverseMass());
        const double inertia = 1.0 / static_cast<double>(own.constants.inverse_inertia);
        const Vec3<double> position =
            inDouble(xyz(own.state.position)) +
            inDouble(lowPart(own.state.position, own.state.velocity, own.state.spin));
        const Vec3<double> velocity = inDouble(xyz(own.state.velocity)), spin = inDouble(xyz(own.state.spin));
        Vec3<double> kicked = velocity, turned = spin;
        if (isMoved(i, Regime::kBonded)) {
            kicked = inDouble(xyz(next.velocity[i]));
            turned = inDouble(xyz(next.spin[i]));
        } else if (isMoved(i, Regime::kRigid)) {
            kicked = axpy(fallTime(i), gravity, velocity + dryKick(2 * size_t{i}));
            turned = spin + dryKick(2 * size_t{i} + 1);
        }
        sums.kinetic = 0.5 * (mass * dot(velocity, kicked) + inertia * dot(spin, turned));
        sums.potential = -mass * dot(gravity, position);
        sums.linear = mass * velocity;
        sums.angular = mass * cross(position, velocity) + inertia * spin;
        return sums;
    }

    DEM_FN bool isMoved(uint32_t i, Regime how) const {
        return regime.data == nullptr ? how == Regime::kBonded : regime[label[i]] == wordOf(how);
    }
    /// Of velocity or spin; none where nothing has been listed yet.
    DEM_FN Vec3<double> dryKick(size_t at) const {
        return at < arrays.carried.count ? inDouble(xyz(arrays.carried[at])) : Vec3<double>{};
    }
    /// s for which gravity pulls what is rigid, from as long before the moment as after it.
    DEM_FN double fallTime(uint32_t i) const {
        return (rememberedFlight(memory[label[i]]).lag + 1.0) * static_cast<double>(params.dt);
    }

    /// m, that an overlap's force counts with: all of it, or what there was when it last pushed. A spring
    /// that is let go has done half of its work by its former force, and none by that of now.
    DEM_FN Real counted(Real overlap, Real former) const {
        return lets_go ? maxOf(former, Real(0)) : overlap;
    }
    /// Contact steps have not come to this contact yet: it has taken in nothing, however deep it is.
    DEM_FN bool isNew(bool rigid, const Vec4<Real>& kept) const { return rigid && holdsNothing(kept); }
    DEM_FN bool isNew(uint32_t i, uint32_t j, const Vec4<Real>& kept) const {
        return isNew(isMoved(i, Regime::kRigid) || isMoved(j, Regime::kRigid), kept);
    }

    DEM_FN double elasticEnergy(const OwnParticle<Real>& own) const {
        double sum = 0;
        for (uint32_t s = arrays.bond_row[own.id]; s < arrays.bond_row[own.id + 1]; ++s)
            if (linkedParticle(arrays.link[s]) > own.id) sum += static_cast<double>(bondSlotEnergy(own, s));
        for (uint32_t s = arrays.contact_row[own.id]; s < arrays.contact_row[own.id + 1]; ++s) {
            const uint32_t j = arrays.neighbour[s];
            if (j < own.id) continue;
            sum += static_cast<double>(contactEnergy(own, j, spheres(own, j), arrays.contact_spring[s]));
        }
        if (own.constants.isHeld()) return sum;
        forEachCollider(params.colliders, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
            sum += static_cast<double>(
                colliderEnergy(own, c, bound, PressesAsKept<Real>{{cornersOf(arrays.corners, own.id)}}));
        });
        return sum;
    }

    DEM_FN Real bondSlotEnergy(const OwnParticle<Real>& own, uint32_t slot) const {
        const BondLink link = arrays.link[slot];
        const uint32_t j = linkedParticle(link);
        const BodyLaw<Real> body = arrays.body_laws[own.owner];
        const BondConstants<Real> bond = bondConstants(arrays.rest[slot], link.grade, body);
        if (pairState(link) == PairState::kContact || pairState(link) == PairState::kFacing)
            return contactEnergy(own, j,
                                 recordedSpheres(link, arrays.rest[slot], own.constants, arrays.constants[j]),
                                 arrays.bond_spring[slot]);
        const PairMotion<Real> pair = pairMotion(own.state, loadState(arrays.in, j));
        if (isBonded(link)) return bondEnergy(bond.stiffness, bondDeformation(bond.rest, pair));
        const Real overlap = maxOf(brokenOverlap(length(bond.rest), length(pair.separation)), Real(0));
        const Vec4<Real> spring = arrays.bond_spring[slot];
        if (isNew(own.id, j, spring)) return Real(0);
        const ParticleConstants<Real> other = arrays.constants[j];
        const BondStiffness<Real> faces =
            cappedFaces(bond, params, pairInertia(own.constants, other), softestOf(spring)).stiffness;
        const Real former = formerOverlap(pair, overlap, length(pair.separation), params.drift);
        return Real(0.5) *
               (faces.normal * overlap * counted(overlap, former) + faces.shear * length2(xyz(spring)));
    }

    DEM_FN Spheres<Real> spheres(const OwnParticle<Real>& own, uint32_t j) const {
        return contactSpheres(own.constants, arrays.constants[j]);
    }
    DEM_FN Real contactEnergy(const OwnParticle<Real>& own, uint32_t j, const Spheres<Real>& spheres,
                              const Vec4<Real>& spring) const {
        const PairLaw<Real> law = arrays.pair_laws[own.owner * params.owners + arrays.owner[j]];
        const ParticleConstants<Real> other = arrays.constants[j];
        const PairMotion<Real> pair = pairMotion(own.state, loadState(arrays.in, j));
        const CentreLine<Real> line = centreLine(pair.separation);
        const Real overlap = (spheres.own + spheres.other) - line.distance;
        if (!(overlap > Real(0)) || isNew(own.id, j, spring) || goThroughEachOther(own.constants, other))
            return Real(0);
        const KeptTouch<Real> touch = touchOf(spring, line.normal);
        const Real former = formerOverlap(pair, overlap, line.distance, params.drift),
                   unloaded = unloadedOverlap(spring, touch, former, overlap), pressed = overlap - unloaded;
        const Real radius = reduced(spheres.own, spheres.other);
        const PairInertia<Real> against = pairInertia(own.constants, other);
        const Real softest = params.softening == 0
                                 ? touch.softest
                                 : softestOfPair<StepKind::kContact>(params, against, touch.softest);
        return touchEnergy(contactTouchLaw(law, params, pressed, radius, against, softest), params,
                           counted(pressed, former - unloaded), touch.spring);
    }

    /// `turned_with`: as a step would have it that asked for the law.
    template <class TurnedWith>
    DEM_FN Real colliderEnergy(const OwnParticle<Real>& own, uint32_t c, const TangentPlane<Real>& bound,
                               const TurnedWith& turned_with) const {
        const Vec4<Real> spring = arrays.collider_spring[c * params.total + own.id];
        const bool is_far = bound.distance > own.constants.floor_radius;
        if (is_far || isNew(isMoved(own.id, Regime::kRigid), spring)) return Real(0);
        const TangentPlane<Real> tangent = tangentFrom(params.colliders, c, own, bound);
        const Pressed<Real> at =
            pressedOn<false>(params, params.colliders, own, turned_with.cell(params, own), c, tangent);
        if (!(at.depth > Real(0))) return Real(0);
        const TouchLaw<Real> law = pressingLaw<TurnedWith::kStep>(
            wallLaw(arrays, params, own.owner, c), params, own, at, turned_with(own, at), {}, spring);
        return touchEnergy(law, params, at.depth, xyz(spring));
    }
};

}  // namespace demolish
