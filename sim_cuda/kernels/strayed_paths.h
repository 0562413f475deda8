// SPDX-License-Identifier: Apache-2.0
// The few that leave the paths on which contact lists rely (predicted_path.h): crumbs that bounce, corners of
// what spins. Lists for all need not be made again for them. They get new paths from where they are; what is
// asked is whom one of them may touch whom its row does not name, and when it may meet somebody with whom the
// last decision has not reckoned.
//
//   list the strayed -> see whom they meet -> start their paths anew
#pragma once
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/find_neighbours.h"
#include "sim_cuda/kernels/insert_pairs.h"
#include "sim_cuda/kernels/paths_now.h"

namespace demolish {

/// With more than this many, lists are made again.
inline constexpr uint32_t kMostStrayed = 192;

/// Words for the host, 0 before: how many have strayed (above kMostStrayed: too many); how many entries the
/// rows lack; when something has to be decided, as soonest() tells it.
inline constexpr uint32_t kStrayedCount = 0, kEntriesLacking = 1, kMustDecide = 2, kStrayWords = 3;

/// One thread a particle or projectile slot.
template <class Real>
struct ListStrayed {
    PathsNow<Real> paths;
    Span<uint32_t> strayed;  ///< kMostStrayed ids, in any order
    Span<uint32_t> words;    ///< kStrayWords

    DEM_FN void operator()(uint32_t i) const {
        if (!paths.strays(i) || atomicLoadU32(&words[kStrayedCount]) > kMostStrayed) return;
        const uint32_t place = atomicAddU32(&words[kStrayedCount], 1);
        if (place < kMostStrayed) strayed[place] = i;
    }
};

/// kThreads threads a particle or projectile slot, which look at all the strayed.
template <uint32_t kThreads, class Real>
struct SeeStrayed {
    PathsNow<Real> paths;
    BondRowsIn<Real> bonds;
    ContactRowsIn<Real> contacts;
    Span<const uint32_t> label, regime;  ///< without `regime` everything is moved with its bonds
    Span<const ParticleConstants<Real>> constants;
    ColliderSet<Real> colliders;
    Real gravity{};    ///< m/s^2
    Real remaining{};  ///< s that the lists hold from here
    Real gentle{};     ///< m/s: no meeting slower than this wakes bonds
    uint32_t in_bodies = 0;
    Span<const uint32_t> strayed;
    Span<uint64_t> lacking;  ///< entries of NewEntries
    Span<uint32_t> words;    ///< kStrayWords

    DEM_FN void operator()(uint32_t thread) const {
        const uint32_t count = words[kStrayedCount], j = thread / kThreads;
        if (count == 0 || count > kMostStrayed || !takesPart(j)) return;
        const PathFromHere<Real> other = paths.now(j);
        const bool enclosed = paths.enclosures.hold(j);
        for (uint32_t k = thread % kThreads; k < count; k += kThreads) {
            const uint32_t i = strayed[k];
            if (enclosed && !isProjectile(i)) continue;
            if (i == j)
                seeColliders(i);
            else if (const PathFromHere<Real> own = paths.anew(i);
                     mayMeet(own, other) && mayTouch(i, j) && !moveAsOne(i, j))
                seePair(i, j, own, other);
        }
    }

  private:
    DEM_FN bool takesPart(uint32_t i) const { return hasPath(paths.paths.velocity[i]); }
    DEM_FN bool isProjectile(uint32_t i) const { return i >= in_bodies; }
    DEM_FN bool mayTouch(uint32_t i, uint32_t j) const {
        return isProjectile(j) || !paths.enclosures.hold(i);
    }
    DEM_FN bool moveAsOne(uint32_t i, uint32_t j) const {
        return label[i] == label[j] && regime.count > 0 && regime[label[i]] != wordOf(Regime::kBonded);
    }
    DEM_FN bool isListed(uint32_t i, uint32_t j) const {
        return findContact(contacts.row_start, contacts.neighbour, i, j) < contacts.row_start[i + 1];
    }
    DEM_FN bool hasRecord(uint32_t i, uint32_t j) const {
        return findBond(bonds.row_start, bonds.link, i, j) < bonds.row_start[i + 1];
    }
    DEM_FN void tell(uint32_t word, Real seconds) const {
        tellSoonest(words[word], static_cast<float>(seconds));
    }

    /// Asked first, since few may.
    DEM_FN bool mayMeet(const PathFromHere<Real>& a, const PathFromHere<Real>& b) const {
        return demolish::mayMeet(a.position, a.velocity, b.position, b.velocity, remaining);
    }
    /// Two that may meet.
    DEM_FN void seePair(uint32_t i, uint32_t j, const PathFromHere<Real>& own,
                        const PathFromHere<Real>& other) const {
        const Vec3<Real> x = xyz(other.position) - xyz(own.position),
                         v = xyz(other.velocity) - xyz(own.velocity);
        const Real gap = length(x) - (reach(i) + reach(j)), speed2 = length2(v);
        const Real seconds = gap > Real(0) ? minOf(gap * inverseSqrt(speed2), remaining) : Real(0);
        if (!isListed(i, j) && !hasRecord(i, j)) list(i, j);
        if (label[i] != label[j] && willMeet(i, j, own, other) &&
            (speed2 > gentle * gentle || !wereToMeet(i, j)))
            tell(kMustDecide, seconds);
    }
    /// m, with its skin: what else a projectile is listed with is no matter of decisions.
    DEM_FN Real reach(uint32_t i) const {
        return constants[i].contact_radius + skinOf(paths.paths.velocity[i]);
    }
    /// If j strays too, it is asked whom it meets and finds i.
    DEM_FN void list(uint32_t i, uint32_t j) const {
        const NewEntries entries{lacking, words.part(kEntriesLacking, 1)};
        entries.add(j, i);
        if (!paths.strays(j)) entries.add(i, j);
    }
    DEM_FN bool willMeet(uint32_t i, uint32_t j, const PathFromHere<Real>& own,
                         const PathFromHere<Real>& other) const {
        return demolish::mayMeet(withW(xyz(own.position), reach(i)), own.velocity,
                                 withW(xyz(other.position), reach(j)), other.velocity, remaining);
    }
    /// By the paths before, and by so much that the last decision has seen it.
    DEM_FN bool wereToMeet(uint32_t i, uint32_t j) const {
        const PathFromHere<Real> a = paths.former(i), b = paths.former(j);
        return demolish::mayMeet(
            withW(xyz(a.position), reach(i) - Real(0.5) * skinOf(a.velocity)), a.velocity,
            withW(xyz(b.position), reach(j) - Real(0.5) * skinOf(b.velocity)), b.velocity, remaining);
    }

    DEM_FN void seeColliders(uint32_t i) const {
        const PathFromHere<Real> own = paths.anew(i), before = paths.former(i);
        const Real radius = constants[i].floor_radius, skin = skinOf(own.velocity);
        for (uint32_t c = 0; c < colliders.count; ++c) {
            const Approach<Real> way = colliders.approach(c, xyz(own.position), xyz(own.velocity));
            const Real gap = way.distance - (radius + skin);
            if (!(way.speed > Real(0)) || !(way.speed * remaining > gap)) continue;
            const Approach<Real> then = colliders.approach(c, xyz(before.position), xyz(before.velocity));
            const bool was_near =
                then.distance - maxOf(then.speed, Real(0)) * remaining < radius + Real(0.5) * skin;
            // What falls gets faster on its way, and is there before its path says so.
            const Real there =
                gap > Real(0) ? squareRoot(madd(way.speed, way.speed, 2 * gravity * gap)) : way.speed;
            if (there > gentle || !was_near)
                tell(kMustDecide, gap > Real(0) ? minOf(2 * gap / (way.speed + there), remaining) : Real(0));
        }
    }
};

/// One thread one of the strayed: its path as if it had always been on it since the build.
template <class Real>
struct RestartStrayed {
    PathsNow<Real> paths;
    Span<const uint32_t> strayed, words;
    Span<Vec4<Real>> built_position, built_velocity;

    DEM_FN void operator()(uint32_t k) const {
        if (k >= words[kStrayedCount] || words[kStrayedCount] > kMostStrayed) return;
        const uint32_t i = strayed[k];
        const PathFromHere<Real> own = paths.anew(i);
        built_position[i] =
            withW(axpy(-paths.elapsed, xyz(own.velocity), xyz(own.position)), reachOf(own.position));
        built_velocity[i] = own.velocity;
    }
};

}  // namespace demolish
