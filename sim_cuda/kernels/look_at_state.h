// SPDX-License-Identifier: Apache-2.0
// A look at the state every few substeps: is all of it finite and inside the scene, do the contact lists
// still hold, and how soon must somebody look again?
#pragma once
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/kernels/paths_now.h"

namespace demolish {

/// Words that a look leaves behind.
inline constexpr uint32_t kLookRebuild = 0, kLookStatus = 1, kLookAgain = 2, kLookWords = 3;
inline constexpr uint32_t kSawNotFinite = 1u, kSawLeftScene = 2u;  // the bits of StepStatus

template <class Real>
struct LookAtState {
    CheckPaths<Real> paths;
    Span<const ParticleConstants<Real>> constants;
    Span<uint32_t> words;  ///< kLookWords, 0 before
    Real scene_radius{};   ///< m

    DEM_FN void operator()(uint32_t i) const {
        if (!(constants[i].takesPart())) return;
        const StateIn<Real>& state = paths.paths.state;
        const Vec3<Real> position = positionOf(state, i);
        const Vec3<Real> velocity = xyz(state.velocity[i]), spin = xyz(state.spin[i]);
        const Vec4<Real> turned = state.rotation[i];
        const Real motion = length2(velocity) + length2(spin) + (length2(xyz(turned)) + turned.w * turned.w),
                   distance2 = length2(position);
        if (!(motion + distance2 <= Real(1e30)))
            atomicOrU32(&words[kLookStatus], kSawNotFinite);
        else if (distance2 > scene_radius * scene_radius)
            atomicOrU32(&words[kLookStatus], kSawLeftScene);
        paths(i);
    }
};

/// A hit throws a particle off its path by what it was hit with, and nobody knows until the next look. By
/// then it may have gone so many of its skins: what kTrustedSkin leaves, so that nothing touches unlisted.
inline constexpr double kSkinsBetweenLooks = 1 - kTrustedSkin;

/// One block of kThreads threads a projectile slot: tells kLookAgain (as soonest() has it) within what time
/// the next look is wanted where the projectile meets something so fast, before the look after the next one,
/// that it must be sooner than usual. Pieces among each other are not asked: looks would cost more than they
/// save.
template <uint32_t kThreads, class Real>
struct SeeFastShots {
    PathsNow<Real> paths;  ///< lookahead: to the end of the next stretch, if it has its usual length
    ContactRowsIn<Real> contacts;
    Span<const ParticleConstants<Real>> constants;
    ColliderSet<Real> colliders;
    Span<uint32_t> words;  ///< kLookWords
    Real usual{};          ///< s, of a stretch

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t shot = paths.enclosures.in_bodies + k / kThreads, part = k % kThreads;
        if (!constants[shot].takesPart()) return;
        for (uint32_t s = contacts.row_start[shot] + part; s < contacts.row_start[shot + 1]; s += kThreads)
            seePair(shot, contacts.neighbour[s]);
        if (part == 0) seeColliders(shot);
    }

  private:
    DEM_FN Vec3<Real> velocity(uint32_t i) const { return xyz(paths.state.velocity[i]); }
    DEM_FN Vec4<Real> ball(uint32_t i) const {
        return withW(positionOf(paths.state, i), reachOf(paths.paths.position[i]));
    }
    /// m that two may come nearer to each other until the next look once they touch.
    DEM_FN Real allowed(uint32_t i) const {
        return Real(kSkinsBetweenLooks) * skinOf(paths.paths.velocity[i]);
    }

    DEM_FN void seePair(uint32_t shot, uint32_t j) const {
        const Vec3<Real> v = velocity(j) - velocity(shot);
        const Real speed2 = length2(v), least = minOf(allowed(shot), allowed(j));
        if (!(speed2 * usual * usual > least * least)) return;
        const Vec4<Real> own = ball(shot), other = ball(j);
        if (!mayMeet(own, paths.state.velocity[shot], other, paths.state.velocity[j], paths.lookahead))
            return;
        const Real reach = constants[shot].contact_radius + constants[j].contact_radius;
        tell(least, length(xyz(other) - xyz(own)) - reach, speed2);
    }
    DEM_FN void seeColliders(uint32_t shot) const {
        forEachCollider(
            colliders, positionOf(paths.state, shot), [&](uint32_t, const TangentPlane<Real>& tangent) {
                const Real sinking = -dot(xyz(tangent.plane), velocity(shot));
                if (sinking > Real(0))
                    tell(allowed(shot), tangent.distance - constants[shot].floor_radius, sinking * sinking);
            });
    }
    /// More than a stretch is as good as never. `gap`: m, until they touch.
    DEM_FN void tell(Real least, Real gap, Real speed2) const {
        const Real seconds = (least + maxOf(gap, Real(0))) * inverseSqrt(speed2);
        if (seconds < usual) tellSoonest(words[kLookAgain], static_cast<float>(seconds));
    }
};

}  // namespace demolish
