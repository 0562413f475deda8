// SPDX-License-Identifier: Apache-2.0
// Which fragments may meet before the next decision, and what follows for how each is moved. A fragment that
// vibrates or is about to be hit hard is moved with its bonds; the others of its island, the fragments that
// may touch, stay rigid. An island sleeps as a whole.
//
//   join fragments that may meet -> flags of each island -> regime of each fragment
//
// Flags are bits set in any order, islands carry their lowest slot: the same on every device.
#pragma once
#include <bit>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/calm_clocks.h"
#include "sim_cuda/kernels/fragment_sums.h"
#include "sim_cuda/kernels/hits_on_colliders.h"
#include "sim_cuda/kernels/join_bonded.h"
#include "sim_cuda/kernels/lead_held.h"
#include "sim_cuda/kernels/meetings.h"
#include "sim_cuda/physics/hand_over.h"

namespace demolish {

/// Of an island: one of its fragments vibrates or is about to be hit hard; one has not rested long enough.
inline constexpr uint32_t kMustBond = 1u, kRestless = 2u;
/// Of a fragment: it vibrates or is about to be hit hard.
inline constexpr uint32_t kNeedsBonds = 4u;

/// Of the sum of two contact radii: a ball that comes farther in a contact step is met in substeps, however
/// few particles it hits. It would be through or round a crumb before contact steps had pushed it back.
inline constexpr double kFarInAStep = 0.25;

/// Threads that share a particle's rows where they are visited: on a GPU there are too few particles to hide
/// the way to memory, and whatever is found is joined or marked in any order. kLater: once it is known who
/// has no meetings.
template <uint32_t kFirstThreads, uint32_t kLaterThreads>
struct MeetingThreads {
    static constexpr uint32_t kFirst = kFirstThreads, kLater = kLaterThreads;
};
using ThreadsOfFew = MeetingThreads<32, 16>;
using ThreadsOfMany = MeetingThreads<8, 4>;
/// Particles up to which they are few.
inline constexpr uint32_t kFewToDecide = 16'384;

/// One thread a slot. Also clears what later kernels of a decision add to.
struct StartIslands {
    Span<uint32_t> island, flags, meets;
    Span<uint32_t> active, carried;    ///< marks
    Span<uint32_t> words, body_awake;  ///< no longer than there are slots
    Span<uint32_t> coming;             ///< HitRules

    DEM_FN void operator()(uint32_t slot) const {
        island[slot] = slot;
        flags[slot] = meets[slot] = active[slot] = carried[slot] = 0;
        if (slot < words.count) words[slot] = 0;
        if (slot < body_awake.count) body_awake[slot] = 0;
        if (slot < coming.count) coming[slot] = 0;
    }
};

/// Which meetings are hard.
template <class Real>
struct HitRules {
    MeetingsIn<Real> meetings;
    FragmentRows rows;
    Span<const uint32_t> regime;     ///< per slot, before the decision
    Span<const WakeLaw<Real>> wake;  ///< per owner; a projectile leaves it to the other
    uint32_t crumb = 1;              ///< particles of the largest piece that stays whole once it is rigid
    HoldsIn holds{};
    Real contact_step{};  ///< s
    /// Per slot: m/s, bits of a float, of the fastest that comes at the fragment before the next decision.
    /// None where no bodies face each other.
    Span<uint32_t> coming{};

    DEM_FN bool isProjectile(uint32_t i) const { return i >= meetings.in_bodies; }
    /// What is held in part cannot give way: a ball would go through its free cells.
    DEM_FN bool isCrumb(uint32_t slot) const {
        return isProjectile(slot) || (rows.size[slot] <= crumb && !holds.holdPart(slot));
    }
    /// Nothing has been decided yet of a ball that has just started: it moves.
    DEM_FN bool sleeps(uint32_t slot) const {
        if (regime[slot] != wordOf(Regime::kAsleep)) return false;
        return !isProjectile(slot) || !(length2(xyz(meetings.state.velocity[slot])) > Real(0));
    }
    /// Particles of the fragment; a projectile is as heavy as any, and so is what is held.
    DEM_FN Real sizeOf(uint32_t slot) const {
        return isProjectile(slot) || holds.hold(slot) ? Real(1e6) : static_cast<Real>(rows.size[slot]);
    }
    /// m/s, between particles of two fragments.
    DEM_FN Real limit(uint32_t i, uint32_t j) const {
        return wakeSpeed(wake[meetings.owner[i]], wake[meetings.owner[j]], sizeOf(meetings.label[i]),
                         sizeOf(meetings.label[j]));
    }
    /// m/s, from which on a hit on something fixed needs the fragment's bonds.
    DEM_FN Real breakingSpeed(uint32_t i) const {
        if (isCrumb(meetings.label[i])) return Real(kNeverHard);
        const WakeLaw<Real> own = wake[meetings.owner[i]];
        return wakeSpeed(own, own, sizeOf(meetings.label[i]), Real(1e6));
    }
    DEM_FN bool canBeHard(uint32_t i, uint32_t j) const {
        return !isCrumb(meetings.label[i]) || !isCrumb(meetings.label[j]) || comesFar(i, j);
    }
    /// A ball, to or from what it may hit.
    DEM_FN bool comesFar(uint32_t i, uint32_t j) const {
        if (isProjectile(i) == isProjectile(j)) return false;
        const Real far =
            Real(kFarInAStep) * (meetings.constants[i].contact_radius + meetings.constants[j].contact_radius);
        return contact_step * contact_step * meetings.relativeSpeed2(i, j) > far * far;
    }
    /// What comes fast towards a sleeper and cannot meet it before the next decision at the latest: the
    /// sleeper sleeps on, and wakes with its bonds. Were it rigid in between, it would sink into the floor as
    /// far as contact steps are softer than substeps, and be hit as it falls: a rabbit shot so lost a
    /// twentieth of its bonds less.
    DEM_FN bool mayWait(uint32_t i, uint32_t j) const {
        return sleeps(meetings.label[i]) != sleeps(meetings.label[j]) && canBeHard(i, j) &&
               isFast(i, j, limit(i, j)) && !meetings.mayMeetWithin(i, j, meetings.at_once);
    }
    /// What is about to hit a fragment goes through it to what it lies against.
    DEM_FN void noteComing(uint32_t i, uint32_t j) const {
        if (coming.empty() || !meetings.comesNearer(i, j)) return;
        const uint32_t bits = std::bit_cast<uint32_t>(float(squareRoot(meetings.relativeSpeed2(i, j))));
        for (const uint32_t slot : {meetings.label[i], meetings.label[j]})
            if (bits > atomicLoadU32(&coming[slot])) atomicMaxU32(&coming[slot], bits);
    }
    /// And so does what it falls on.
    DEM_FN void noteLanding(uint32_t i, const HitsOnColliders<Real>& landing) const {
        const uint32_t slot = meetings.label[i];
        if (!landing.find(meetings, i, breakingSpeed(i)).at_once) return;
        const Real speed = squareRoot(length2(xyz(meetings.state.velocity[i])));
        atomicMaxU32(&coming[slot], std::bit_cast<uint32_t>(float(speed)));
    }
    DEM_FN Real comingAt(uint32_t slot) const {
        return coming.empty() ? Real(0) : Real(std::bit_cast<float>(coming[slot]));
    }
    /// i lies against j, and something comes at one of the two that would break the other: both need their
    /// bonds, since what is rigid pushes softly.
    DEM_FN bool isPushedHard(uint32_t i, uint32_t j, Real apart) const {
        if (!(apart > Real(0)) || !canBeHard(i, j)) return false;
        const Real reach = Real(kNearlyFacing) * apart;
        const Real fastest = maxOf(comingAt(meetings.label[i]), comingAt(meetings.label[j]));
        return fastest > limit(i, j) && meetings.apart2(i, j) < reach * reach;
    }
    DEM_FN bool isFast(uint32_t i, uint32_t j, Real limit) const {
        return meetings.relativeSpeed2(i, j) > limit * limit;
    }
    /// Is the hit hard if it comes within `time` (s)? To a sleeper that cannot wait, what is fast and may
    /// meet it at all.
    DEM_FN bool isHard(uint32_t i, uint32_t j, Real time) const {
        const Real above = limit(i, j);
        return sleeps(meetings.label[i]) ? isFast(i, j, above) && meetings.mayMeetWithin(i, j, time)
                                         : meetings.meetHard(i, j, above, time);
    }
};

/// Reads both at the same time.
DEM_FN void raise(uint32_t& a, uint32_t& b) {
    const uint32_t raised_a = atomicLoadU32(&a), raised_b = atomicLoadU32(&b);
    if (raised_a == 0) atomicOrU32(&a, 1u);
    if (raised_b == 0) atomicOrU32(&b, 1u);
}

/// kThreads threads a particle or projectile slot.
template <uint32_t kThreads, class Real>
struct JoinIslands {
    HitRules<Real> rules;
    HitsOnColliders<Real> landing;
    Span<uint32_t> island;
    Span<uint32_t> meets;  ///< 1: has meetings; of most particles the later kernels need not ask
    Span<uint32_t> words;  ///< kWorkWords

    DEM_FN void operator()(uint32_t k) const {
        const MeetingsIn<Real>& meetings = rules.meetings;
        const uint32_t i = k / kThreads;
        if (!meetings.takesPart(i)) return;
        const uint32_t own = meetings.label[i];
        if (!rules.coming.empty() && k % kThreads == 0) rules.noteLanding(i, landing);
        meetings.template visitMeetings<kThreads>(i, k % kThreads, true, [&](uint32_t j, Real apart) {
            raise(meets[i], meets[j]);
            const bool faces = apart > Real(0);
            if (!faces && rules.mayWait(i, j)) return raise(words[kHitsLater]);
            join(island, own, meetings.label[j]);
            if (!faces) rules.noteComing(i, j);
        });
    }
};

/// What a decision goes by.
struct RegimeRules {
    bool hand_over = false, sleeping = false;
    bool may_calm = false;    ///< a frame starts: bonds may come to rest; else they may only be woken
    bool all_bonded = false;  ///< so much must be moved with its bonds that all that is awake goes with it
    bool no_bonds = false;    ///< nothing is ever moved with its bonds
    uint32_t calm_substeps = 0, rest_substeps = 0;
};

/// kThreads threads a particle or projectile slot.
template <uint32_t kThreads, class Real>
struct FlagIslands {
    HitRules<Real> hits;
    Span<const uint32_t> island, meets;
    Span<const CalmClock> clock;
    HitsOnColliders<Real> landing;
    RegimeRules rules;
    Span<uint32_t> flags;
    Span<uint32_t> words;  ///< kWorkWords

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t i = k / kThreads, part = k % kThreads;
        if (!hits.meetings.takesPart(i)) return;
        const uint32_t slot = hits.meetings.label[i];
        uint32_t found = i == slot ? ownFlags(slot) : 0;
        if ((found & kMustBond) == 0) {
            const HardHits hard = hardHits(i, slot, part);
            if (hard.at_once) found |= kMustBond;
            if (hard.later) raise(words[kHitsLater]);
        }
        if (found != 0) atomicOrU32(&flags[island[slot]], found);
        if ((found & kMustBond) != 0) atomicOrU32(&flags[slot], kNeedsBonds);
    }

  private:
    DEM_FN uint32_t ownFlags(uint32_t slot) const {
        const bool rested = clock[slot].rest >= rules.rest_substeps;
        const uint32_t restless = rested ? 0 : kRestless;
        const bool bonds_work = !rules.no_bonds && hits.regime[slot] == wordOf(Regime::kBonded);
        if (hits.isProjectile(slot) || !bonds_work) return restless;
        const bool calm = rules.hand_over && clock[slot].calm >= rules.calm_substeps;
        return rules.may_calm && (calm || rested) ? restless : restless | kMustBond;
    }
    DEM_FN HardHits hardHits(uint32_t i, uint32_t slot, uint32_t part) const {
        const MeetingsIn<Real>& meetings = hits.meetings;
        HardHits hard;
        if (part == 0) hard = landing.find(meetings, i, hits.breakingSpeed(i));
        if (meets[i] == 0) return hard;
        const bool sleeps = hits.sleeps(slot);
        const auto mayBeHard = [&](uint32_t other) {
            // Sleepers do not hit each other.
            return !sleeps || !hits.sleeps(other) || hits.comingAt(other) > Real(0) ||
                   hits.comingAt(slot) > Real(0);
        };
        const auto ask = [&](uint32_t j, Real apart) {
            if (hits.isPushedHard(i, j, apart)) hard.at_once = true;
            if (hits.canBeHard(i, j) && hits.isHard(i, j, meetings.soon))
                (hits.isHard(i, j, meetings.at_once) ? hard.at_once : hard.later) = true;
        };
        meetings.template visitMeetingsWith<kThreads>(i, part, false, mayBeHard, ask);
        return hard;
    }
};

/// Raises the word when a particle that is awake may meet one that sleeps. kThreads threads a particle or
/// projectile slot.
template <uint32_t kThreads, class Real>
struct SeeSleepers {
    MeetingsIn<Real> meetings;
    Span<const uint32_t> regime;
    Span<uint32_t> word;

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t i = k / kThreads;
        if (!meetings.takesPart(i) || sleeps(i)) return;
        meetings.template visitMeetings<kThreads>(i, k % kThreads, false, [&](uint32_t j, Real) {
            if (sleeps(j)) atomicOrU32(&word[0], 1u);
        });
    }
    DEM_FN bool sleeps(uint32_t i) const { return regime[meetings.label[i]] == wordOf(Regime::kAsleep); }
};

/// One thread a slot. `former` keeps what it was.
template <class Real>
struct ChooseRegimes {
    Span<const uint32_t> label, island, flags;
    Span<const ParticleConstants<Real>> constants;
    RegimeRules rules;
    Span<uint32_t> regime, former;
    Span<CalmClock> clock;
    uint32_t in_bodies = 0;
    HoldsIn holds{};

    DEM_FN void operator()(uint32_t slot) const {
        if (label[slot] != slot) return;
        const uint32_t before = regime[slot];
        const Regime chosen = choose(slot);
        former[slot] = before;
        regime[slot] = wordOf(chosen);
        if (chosen == Regime::kBonded && before != wordOf(Regime::kBonded) && needsBonds(slot))
            clock[slot] = {};
    }
    /// A projectile goes along with the bonds that it may touch: it costs no more in either way.
    DEM_FN bool needsBonds(uint32_t slot) const {
        if (rules.no_bonds) return false;
        if (holds.bend(slot)) return true;
        const bool with_island = !rules.hand_over || slot >= in_bodies;
        return (with_island ? flags[island[slot]] & kMustBond : flags[slot] & kNeedsBonds) != 0;
    }
    DEM_FN Regime choose(uint32_t slot) const {
        if (!(constants[slot].takesPart())) return Regime::kAsleep;
        if (needsBonds(slot)) return Regime::kBonded;
        if (rules.sleeping && (flags[island[slot]] & (kMustBond | kRestless)) == 0) return Regime::kAsleep;
        return rules.hand_over && !rules.all_bonded ? Regime::kRigid : Regime::kBonded;
    }
};

}  // namespace demolish
