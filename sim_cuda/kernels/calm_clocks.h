// SPDX-License-Identifier: Apache-2.0
// For how long each fragment has been calm inside and at rest, watched once a frame.
#pragma once
#include <bit>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/lead_held.h"
#include "sim_cuda/physics/hand_over.h"

namespace demolish {

/// Where a particle was when its motion was last measured.
struct FormerPose {
    Vec3<double> position;             ///< m
    Quat<float> rotation{0, 0, 0, 0};  ///< 0: not known

    DEM_FN bool isKnown() const { return rotation.w != 0 || length2(vectorPart(rotation)) > 0; }
};

/// Fastest particle of each fragment: squared speeds as words, which keep their order. What a crumb between
/// others swings from one contact step to the next is no motion, however fast: it comes nowhere. So a
/// particle is as slow as it is now, or as its way since it was last measured says.
template <class Real>
struct MeasureMotion {
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const uint32_t> label;
    Span<FormerPose> former;
    Span<uint32_t> fastest;  ///< per slot, 0 before; float bits of m^2/s^2
    double passed = 0;       ///< s since it was last measured; 0: this look counts for no way

    DEM_FN void operator()(uint32_t i) const {
        if (!(constants[i].takesPart())) return;
        const double radius = double(constants[i].contact_radius);
        const auto now2 =
            double(length2(xyz(state.velocity[i]))) + radius * radius * double(length2(xyz(state.spin[i])));
        const double speed2 = minOf(now2, alongWay2(i, radius));
        if (passed > 0 || !former[i].isKnown()) former[i] = {exactPosition(state, i), rotation(i)};
        const uint32_t bits = std::bit_cast<uint32_t>(float(speed2));
        uint32_t& word = fastest[label[i]];
        if (bits > atomicLoadU32(&word)) atomicMaxU32(&word, bits);
    }

  private:
    DEM_FN Quat<float> rotation(uint32_t i) const {
        const Vec4<Real> q = state.rotation[i];
        return {float(q.x), float(q.y), float(q.z), float(q.w)};
    }
    DEM_FN double alongWay2(uint32_t i, double radius) const {
        const FormerPose before = former[i];
        if (!(passed > 0) || !before.isKnown()) return kNoSpeedLimit2;
        const Vec3<double> way = exactPosition(state, i) - before.position;
        const double turn2 = 4 * double(length2(vectorPart(relativeRotation(before.rotation, rotation(i)))));
        return (length2(way) + radius * radius * turn2) / (passed * passed);
    }
    static constexpr double kNoSpeedLimit2 = 1e30;
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
