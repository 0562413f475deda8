// SPDX-License-Identifier: Apache-2.0
// For how long each fragment has been calm inside and at rest, watched once a frame.
#pragma once
#include <bit>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/lead_held.h"
#include "sim_cuda/physics/hand_over.h"

namespace demolish {

/// Fastest particle of each fragment: squared speeds as words, which keep their order.
template <class Real>
struct MeasureMotion {
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const uint32_t> label;
    Span<uint32_t> fastest;  ///< per slot, 0 before; float bits of m^2/s^2

    DEM_FN void operator()(uint32_t i) const {
        if (!(constants[i].takesPart())) return;
        const Real radius = constants[i].contact_radius;
        const Real speed2 = length2(xyz(state.velocity[i])) + radius * radius * length2(xyz(state.spin[i]));
        const uint32_t bits = std::bit_cast<uint32_t>(float(speed2));
        uint32_t& word = fastest[label[i]];
        if (bits > atomicLoadU32(&word)) atomicMaxU32(&word, bits);
    }
};

/// Substeps for which a fragment has been calm inside, and at rest.
struct CalmClock {
    uint32_t calm = 0, rest = 0;
};

/// One thread a slot, once a frame.
template <class Real>
struct AdvanceClocks {
    FragmentRows rows;
    Span<const uint32_t> label, owner, fastest;
    Span<const ParticleConstants<Real>> constants;
    Span<const RigidMotion> motion;  ///< per slot of a body's fragment
    Span<const PoseSums> pose;       ///< by place
    Span<const SpinSums> spin;       ///< by place
    Span<const double> calm_speed2;  ///< per owner, m^2/s^2
    Span<const uint32_t> age;  ///< per slot of a body's fragment: frames, 1: it has just come into being
    Span<CalmClock> clock;
    float rest_speed2 = 0;
    uint32_t in_bodies = 0;
    uint32_t substeps = 0;  ///< since the last time
    HoldsIn holds{};
    StateIn<Real> state{};

    DEM_FN void operator()(uint32_t slot) const {
        if (label[slot] != slot || !(constants[slot].takesPart())) return;
        CalmClock next = clock[slot];
        const bool rests = std::bit_cast<float>(fastest[slot]) <= rest_speed2 && !holds.lead(slot);
        next.calm = !isCalm(slot) ? 0 : isNewborn(slot) ? next.calm : grown(next.calm);
        next.rest = rests ? grown(next.rest) : 0;
        clock[slot] = next;
    }
    DEM_FN bool isCalm(uint32_t slot) const {
        if (slot >= in_bodies) return true;
        const uint32_t place = rows.first[slot];
        return 2 * energyInside(slot, place) <= calm_speed2[owner[slot]] * pose[place].now.mass;
    }
    /// J, against its rigid motion: that of what is held of it, or what fits it best.
    DEM_FN double energyInside(uint32_t slot, uint32_t place) const {
        if (!holds.hold(slot)) return innerEnergy(spin[place], motion[slot]);
        const uint32_t leader = holds.leader[slot];
        const Vec3<double> turn = asDouble(xyz(state.spin[leader])),
                           arm = motion[slot].centre - exactPosition(state, leader);
        return energyAgainst(
            spin[place], pose[place].now.mass, turn,
            motion[slot].velocity - velocityAt(asDouble(xyz(state.velocity[leader])), turn, arm));
    }
    /// It may be in the middle of the hit that broke it off, whose contacts longer steps would not bear: a
    /// frame of its own has to pass.
    DEM_FN bool isNewborn(uint32_t slot) const { return slot < in_bodies && age[slot] == 1; }
    DEM_FN uint32_t grown(uint32_t before) const { return before > 0x7fffffffu ? before : before + substeps; }
};

}  // namespace demolish
