// SPDX-License-Identifier: Apache-2.0
// What anchors hold (api/anchors.h): who of a fragment is held, how that bears on how it may be moved, and
// the velocities with which paths lead particles.
//
//   find the lowest held particle of each fragment -> flags of each fragment
//   lead held particles -> the rigid bodies that they belong to
#pragma once
#include "sim_cuda/api/anchors.h"
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/fragment_sums.h"

namespace demolish {

/// Of a particle: the number of its path, or kStands, or kFree. Of a fragment's slot: no particle is held.
inline constexpr uint32_t kStands = 0xfffffffeu, kFree = 0xffffffffu;

/// Of a fragment: some of it is free, some of it is led anywhere in this frame, or not all of what is held
/// has the same path.
inline constexpr uint32_t kHasFree = 1u, kIsLed = 2u, kPathsDiffer = 4u;

/// Per slot; empty where a scene holds nothing.
struct HoldsIn {
    Span<const uint32_t> leader;  ///< lowest held particle of the fragment, or kFree
    Span<const uint32_t> flags;

    DEM_FN bool hold(uint32_t slot) const { return !leader.empty() && leader[slot] != kFree; }
    DEM_FN bool lead(uint32_t slot) const { return hold(slot) && (flags[slot] & kIsLed) != 0; }
    /// Of it some is held and some is free.
    DEM_FN bool holdPart(uint32_t slot) const { return hold(slot) && (flags[slot] & kHasFree) != 0; }
    /// It bends between its anchors, so that no rigid motion fits it.
    DEM_FN bool bend(uint32_t slot) const {
        return lead(slot) && (flags[slot] & (kHasFree | kPathsDiffer)) != 0;
    }
};

/// One thread a slot.
struct StartHolds {
    Span<uint32_t> leader, flags;

    DEM_FN void operator()(uint32_t slot) const {
        leader[slot] = kFree;
        flags[slot] = 0;
    }
};
/// One thread a particle of a body.
struct FindLeaders {
    Span<const uint32_t> label, path;
    Span<uint32_t> leader;

    DEM_FN void operator()(uint32_t i) const {
        if (path[i] != kFree) atomicMinU32(&leader[label[i]], i);
    }
};
struct FlagHolds {
    Span<const uint32_t> label, path, leader;
    Span<uint32_t> flags;
    uint32_t led = 0;  ///< a bit a path: those that lead anywhere

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t slot = label[i], own = path[i];
        uint32_t found = own == kFree ? kHasFree : 0;
        if (own < kMaxPaths && (led >> own & 1u) != 0) found |= kIsLed;
        if (own != kFree && own != path[leader[slot]]) found |= kPathsDiffer;
        if (found != 0) atomicOrU32(&flags[slot], found);
    }
};

/// A particle on a path, where it is at the start.
struct LedParticle {
    uint32_t id = 0, path = 0;
    Vec3<double> from_pivot;  ///< m
    Quat<double> rotation;
};
/// What a path does until a moment `ahead` of now.
struct PathAhead {
    Vec3<double> pivot;               ///< m, then
    Quat<double> turned_now, turned;  ///< about it since the start, now and then
    Vec3<double> spin;                ///< rad/s, on the way
};

/// Particles get the velocity that takes them to where their path is then, from wherever they are: nothing
/// adds up. One thread a particle of a path.
template <class Real>
struct LeadHeld {
    Span<const LedParticle> particle;
    PathAhead path[kMaxPaths];
    uint32_t led = 0;  ///< a bit a path; the others stand
    double ahead = 0;  ///< s
    StateIn<Real> now;
    StateOut<Real> state, other;  ///< the memory behind `now`; the other instant
    Span<Vec4<Real>> led_from;    ///< as in SubstepArrays

    DEM_FN void operator()(uint32_t k) const {
        const LedParticle own = particle[k];
        if ((led >> own.path & 1u) == 0) return set(own.id, {}, {});
        const PathAhead& to = path[own.path];
        const Vec3<double> target = to.pivot + rotate(to.turned, own.from_pivot);
        const Vec4<Real> q = now.rotation[own.id];
        const Quat<double> is{double(q.x), double(q.y), double(q.z), double(q.w)};
        const Quat<double> off = relativeRotation(is, multiply(to.turned_now, own.rotation));
        const double twice = off.w < 0 ? -2.0 : 2.0;
        set(own.id, (1 / ahead) * (target - exactPosition(now, own.id)),
            axpy(twice / ahead, vectorPart(off), to.spin));
    }

  private:
    DEM_FN void set(uint32_t i, const Vec3<double>& v, const Vec3<double>& w) const {
        const Vec3<Real> velocity{Real(v.x), Real(v.y), Real(v.z)}, spin{Real(w.x), Real(w.y), Real(w.z)};
        Vec4<Real>&from = led_from[2 * size_t{i}], &turned_from = led_from[2 * size_t{i} + 1];
        from = withW(xyz(from) + (xyz(now.velocity[i]) - velocity), Real(0));
        turned_from = withW(xyz(turned_from) + (xyz(now.spin[i]) - spin), Real(0));
        state.velocity[i] = withLowOf(velocity, state.velocity[i]);
        state.spin[i] = withLowOf(spin, state.spin[i]);
        other.velocity[i] = withLowOf(velocity, other.velocity[i]);
        other.spin[i] = withLowOf(spin, other.spin[i]);
    }
};

/// One thread a slot: a rigid body moves as its lowest held particle does, on which it was hung.
template <class Real>
struct LeadBodies {
    HoldsIn holds;
    Span<const uint32_t> label, regime;
    StateIn<Real> now;
    Span<RigidBody> body;

    DEM_FN void operator()(uint32_t slot) const {
        if (label[slot] != slot || regime[slot] != wordOf(Regime::kRigid) || !holds.hold(slot)) return;
        const uint32_t leader = holds.leader[slot];
        body[slot].velocity = asDouble(xyz(now.velocity[leader]));
        body[slot].spin = asDouble(xyz(now.spin[leader]));
    }
};

}  // namespace demolish
