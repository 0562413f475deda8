// SPDX-License-Identifier: Apache-2.0
// Which particles of different fragments may meet before the next decision (islands.h), and how fast.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/predicted_path.h"

namespace demolish {

/// Times the sum of two contact radii: faces touch before the spheres do.
inline constexpr double kNearlyTouching = 1.3;
/// Times the distance at which cells of two bodies touch that have been against each other since the start.
inline constexpr double kNearlyFacing = 1.05;

/// What the decisions read of the present state.
template <class Real>
struct MeetingsIn {
    StateIn<Real> state;
    PathsIn<Real> paths;
    Span<const ParticleConstants<Real>> constants;
    Span<const uint32_t> label;  ///< per particle and projectile slot: its fragment's slot
    Span<const uint32_t> owner;
    BondRowsIn<Real> bonds;
    ContactRowsIn<Real> contacts;
    uint32_t in_bodies = 0;
    Real horizon{};  ///< s that the contact lists hold from their build on
    Real soon{};     ///< s until the next decision at the latest
    Real at_once{};  ///< s, not above `soon`: a hit within them cannot wait for the next decision

    DEM_FN bool takesPart(uint32_t i) const { return constants[i].takesPart(); }
    /// On straight paths from here, skins included: whoever strays from the path that the contact lists rely
    /// on by half a skin brings a new decision where one is needed (strayed_paths.h).
    DEM_FN bool mayMeetSoon(uint32_t i, uint32_t j) const { return mayMeetWithin(i, j, soon); }
    DEM_FN bool mayMeetWithin(uint32_t i, uint32_t j, Real time) const {
        return mayMeet(withW(positionOf(state, i), reach(i)), state.velocity[i],
                       withW(positionOf(state, j), reach(j)), state.velocity[j], time);
    }
    /// m, with its skin.
    DEM_FN Real reach(uint32_t i) const { return constants[i].contact_radius + skinOf(paths.velocity[i]); }
    /// m^2/s^2
    DEM_FN Real relativeSpeed2(uint32_t i, uint32_t j) const {
        return length2(xyz(state.velocity[j]) - xyz(state.velocity[i]));
    }
    /// m^2
    DEM_FN Real apart2(uint32_t i, uint32_t j) const {
        return length2(positionOf(state, j) - positionOf(state, i));
    }
    DEM_FN bool comesNearer(uint32_t i, uint32_t j) const {
        return dot(positionOf(state, j) - positionOf(state, i),
                   xyz(state.velocity[j]) - xyz(state.velocity[i])) < Real(0);
    }
    /// Closing faster than `limit` (m/s), and touching or, on straight paths, within `time` (s) from here.
    DEM_FN bool meetHard(uint32_t i, uint32_t j, Real limit, Real time) const {
        const Vec3<Real> x = positionOf(state, j) - positionOf(state, i);
        const Vec3<Real> v = xyz(state.velocity[j]) - xyz(state.velocity[i]);
        const Real speed2 = length2(v), closing = -dot(x, v);
        if (!(speed2 > limit * limit) || !(closing > Real(0))) return false;
        const Real reach =
                       Real(kNearlyTouching) * (constants[i].contact_radius + constants[j].contact_radius),
                   apart2 = length2(x);
        if (apart2 < reach * reach) return closing * closing > limit * limit * apart2;
        const Real nearest = minOf(closing / speed2, time);
        return length2(axpy(nearest, v, x)) < reach * reach;
    }

    /// visit(j, apart) for the particles of other fragments that i may touch before the next decision, those
    /// above i only with `above`: what is found in every kThreads-th slot of its rows from slot `part` on.
    /// `apart`: m, where kFacing cells touch; 0 for all others.
    template <uint32_t kThreads, class Visit>
    DEM_FN void visitMeetings(uint32_t i, uint32_t part, bool above, const Visit& visit) const {
        visitMeetingsWith<kThreads>(
            i, part, above, [](uint32_t) { return true; }, visit);
    }
    /// With fragments only whose slot is `wanted`.
    template <uint32_t kThreads, class Wanted, class Visit>
    DEM_FN void visitMeetingsWith(uint32_t i, uint32_t part, bool above, const Wanted& wanted,
                                  const Visit& visit) const {
        const uint32_t own = label[i];
        for (uint32_t s = bonds.row_start[i] + part; s < bonds.row_start[i + 1]; s += kThreads) {
            const BondLink link = bonds.link[s];
            const uint32_t j = linkedParticle(link);
            if (isBonded(link) || (above && j < i) || label[j] == own || !wanted(label[j])) continue;
            if (pairState(link) == PairState::kFacing)
                visit(j, length(xyz(bonds.rest[s])));
            else if (hasFaces(link) || mayMeetSoon(i, j))
                visit(j, Real(0));
        }
        for (uint32_t s = contacts.row_start[i] + part; s < contacts.row_start[i + 1]; s += kThreads) {
            const uint32_t j = contacts.neighbour[s];
            if ((above && j < i) || label[j] == own || !wanted(label[j])) continue;
            if (mayMeetSoon(i, j)) visit(j, Real(0));
        }
    }
};

}  // namespace demolish
