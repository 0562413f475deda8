// SPDX-License-Identifier: Apache-2.0
// The lists of what is moved (data/regimes.h), made in the order of ids by one scan over rows of marks:
// particles of rigid fragments that may touch something, rigid fragments, particles moved with their bonds,
// particles of rigid fragments that may touch those.
#pragma once
#include "sim_cuda/kernels/start_rigid.h"

namespace demolish {

/// Places 0 .. total-1: particles in order of (fragment, id), then projectile slots.
struct PlacesIn {
    FragmentRows rows;
    uint32_t in_bodies = 0, total = 0;
    DEM_FN uint32_t particleAt(uint32_t place) const { return place < in_bodies ? rows.order[place] : place; }
    DEM_FN uint32_t first(uint32_t slot) const { return slot < in_bodies ? rows.first[slot] : slot; }
    DEM_FN uint32_t size(uint32_t slot) const { return slot < in_bodies ? rows.size[slot] : 1; }
};

/// kThreads threads a place; the marks that they may set are 0 before.
template <uint32_t kThreads, class Real>
struct MarkWork {
    MeetingsIn<Real> meetings;
    PlacesIn places;
    Span<const uint32_t> regime;
    Span<const uint32_t> meets;  ///< as JoinIslands has found it; empty: particles have been moved since
    ColliderSet<Real> colliders;
    Span<uint32_t> active, fragment, bonded, carried;  ///< marks: by place, by slot, by particle, by particle

    DEM_FN void operator()(uint32_t thread) const {
        const uint32_t k = thread / kThreads, part = thread % kThreads, i = places.particleAt(k);
        if (part == 0) {
            fragment[k] = meetings.label[k] == k && isIn(k, Regime::kRigid) ? 1 : 0;
            bonded[k] = k < places.in_bodies && isIn(k, Regime::kBonded) ? 1 : 0;
        }
        if (!isIn(i, Regime::kRigid)) return;
        const Near near = nearOf(i, part);
        if (near.anything) atomicOrU32(&active[k], 1);
        if (near.bonded && i < places.in_bodies) atomicOrU32(&carried[i], 1);
    }

  private:
    DEM_FN bool isIn(uint32_t i, Regime wanted) const { return regime[meetings.label[i]] == wordOf(wanted); }
    struct Near {
        bool anything = false, bonded = false;
    };
    DEM_FN Near nearOf(uint32_t i, uint32_t part) const {
        Near near{part == 0 && nearCollider(i), false};
        if (!meets.empty() && meets[i] == 0) return near;
        meetings.template visitMeetings<kThreads>(i, part, false, [&](uint32_t j, Real) {
            near.anything = true;
            near.bonded = near.bonded || isIn(j, Regime::kBonded);
        });
        return near;
    }
    /// On the straight path that the contact lists rely on: a particle off it by more than its skin brings
    /// this question again, if its new path leads to a collider (strayed_paths.h).
    DEM_FN bool nearCollider(uint32_t i) const {
        const Vec4<Real> position = meetings.paths.position[i], velocity = meetings.paths.velocity[i];
        const Real reach = meetings.constants[i].floor_radius + skinOf(velocity);
        bool near = false;
        for (uint32_t c = 0; c < colliders.count; ++c) {
            const Approach<Real> way = colliders.approach(c, xyz(position), xyz(velocity));
            if (madd(-maxOf(way.speed, Real(0)), meetings.horizon, way.distance) < reach) near = true;
        }
        return near;
    }
};

inline constexpr uint32_t kMarkRows = 4;

/// After the scan of the rows of marks, one after the other (kMarkRows total + 1 sums).
template <class Real>
struct WriteWork {
    PlacesIn places;
    Span<const uint32_t> label, regime, sums, owner;
    Span<const uint32_t> flags;  ///< of fragments, as FlagIslands leaves them
    Span<const RigidBody> body;
    Span<const Vec3<double>> arm;
    Span<const ParticleConstants<Real>> own_constants;
    Span<uint32_t> active, fragment, first, last, bonded;
    Span<uint32_t> large;                       ///< entries with long rows, in any order
    Span<uint32_t> words;                       ///< kWorkWords, 0 before: what the host wants to know
    Span<uint32_t> body_awake;                  ///< per body, 0 before
    Span<ParticleConstants<Real>> constants;    ///< of contact steps
    Span<ParticleConstants<Real>> in_substeps;  ///< of substeps, where rigid fragments move too

    DEM_FN uint32_t sum(uint32_t row, uint32_t k) const {
        return sums[row * places.total + k] - sums[row * places.total];
    }
    DEM_FN bool marked(uint32_t row, uint32_t k) const {
        return sums[row * places.total + k + 1] != sums[row * places.total + k];
    }

    DEM_FN void operator()(uint32_t k) const {
        if (k == 0) tellLengths();
        if (k < places.in_bodies && label[k] == k) countAwake(k);
        if (k >= places.in_bodies && own_constants[k].takesPart() &&
            regime[label[k]] == wordOf(Regime::kBonded))
            atomicMaxU32(&words[kBondedShots], 1);
        if (marked(0, k)) active[sum(0, k)] = places.particleAt(k);
        if (marked(2, k)) bonded[sum(2, k)] = k;
        if (marked(3, k)) bonded[sum(2, places.total) + sum(3, k)] = k;
        writeConstants(k, label[k]);
        if (!marked(1, k)) return;
        const uint32_t entry = sum(1, k);
        fragment[entry] = k;
        first[entry] = sum(0, places.first(k));
        last[entry] = end(k);
        if (last[entry] - first[entry] > kShortRigidRow) large[atomicAddU32(&words[kLargeCount], 1)] = entry;
    }
    DEM_FN void writeConstants(uint32_t k, uint32_t slot) const {
        const ParticleConstants<Real> own = own_constants[k];
        constants[k] = regime[slot] == wordOf(Regime::kBonded) ? own.seenByOther() : own;
        in_substeps[k] = own;
        if (regime[slot] != wordOf(Regime::kRigid)) return;
        constants[k] = sharedConstants(body[slot], arm[k], own);
        in_substeps[k] = carriedConstants(body[slot], constants[k], own);
    }
    DEM_FN void tellLengths() const {
        words[kActiveCount] = sum(0, places.total);
        words[kFragmentCount] = sum(1, places.total);
        words[kBondedCount] = sum(2, places.total);
        words[kCarriedCount] = sum(3, places.total);
    }
    /// What sleeps and what does not, a fragment at a time.
    DEM_FN void countAwake(uint32_t slot) const {
        if (regime[slot] == wordOf(Regime::kAsleep)) {
            atomicAddU32(&words[kAsleepCount], 1);
            return;
        }
        const uint32_t size = places.size(slot);
        atomicAddU32(&words[kAwakeCount], size);
        if ((flags[slot] & kNeedsBonds) != 0) atomicAddU32(&words[kMustBondCount], size);
        uint32_t& awake = body_awake[owner[slot]];
        if (atomicLoadU32(&awake) == 0 && atomicMaxU32(&awake, 1) == 0) atomicAddU32(&words[kAwakeBodies], 1);
    }
    DEM_FN uint32_t end(uint32_t slot) const { return sum(0, places.first(slot) + places.size(slot)); }
};

}  // namespace demolish
