// SPDX-License-Identifier: Apache-2.0
// The corners of a cell on a plane: springs side by side, added up by what they press with. A particle
// without corners is a sphere.
#pragma once
#include "sim_cuda/backend/lane_group.h"
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/kernels/own_particle.h"
#include "sim_cuda/physics/touch_effect.h"

namespace demolish {

/// Stiffness of a corner over that of a contact: a cell that lies on a face of five corners is as stiff as a
/// sphere.
inline constexpr double kCornerShare = 0.2;
/// Rolling resistance of a cell on its corners over that of a sphere: edges resist by themselves. With 1 a
/// cube sleeps on its edge, with 0 nothing comes to rest.
inline constexpr double kCornerRolling = 0.3;
/// m, farther than anything is.
inline constexpr double kFarAway = 1e30;

/// A particle's cell as a step sees it.
template <class Real>
struct SeenCell {
    OwnCorners<Real> corners;
    Quat<Real> turned;  ///< its orientation
    Real drift{};       ///< s, way from the state before to this one
};

/// How a particle is pressed on a collider.
template <class Real>
struct Pressed {
    Vec3<Real> normal;  ///< unit, out of the collider
    Vec3<Real> arm;     ///< m, from the particle's centre to the centre of pressure
    Vec3<Real> couple;  ///< m, torque beside that of a push at the centre of pressure, over that push
    Real depth{};       ///< m, of the points, each by what it presses with; not above 0: none touches
    Real springs{1};    ///< springs of this depth that press as hard
    Real gap{};         ///< m, to the lowest point
    Real rolling{1};    ///< share of the rolling resistance
    OverlapChange<Real> change;  ///< for the ledger
};

/// What presses, in units of the law's constant. kHertz: as StepParams::hertz.
template <bool kHertz, class Real>
DEM_FN Real pressOf(Real depth) {
    return kHertz ? depth * squareRoot(depth) : depth;
}

/// Depths of points added up, each by what it presses with.
template <class Real>
struct DepthSums {
    Real force{};                  ///< pressOf()
    Real energy{};                 ///< of force times depth
    Real nearest{Real(kFarAway)};  ///< m, above the surface
    Vec3<Real> arm;                ///< m, each by its force; in the frame of those that were added

    DEM_FN bool touches() const { return force > Real(0); }
    DEM_FN Vec3<Real> meanArm() const { return (Real(1) / force) * arm; }
};
/// `distance`: m, above the surface. Gives pressOf() it.
template <bool kHertz, class Real>
DEM_FN Real addDepth(DepthSums<Real>& sums, Real distance, const Vec3<Real>& arm) {
    sums.nearest = minOf(sums.nearest, distance);
    const Real depth = maxOf(-distance, Real(0)), force = pressOf<kHertz>(depth);
    sums.force = sums.force + force;
    sums.energy = madd(force, depth, sums.energy);
    sums.arm = axpy(force, arm, sums.arm);
    return force;
}
template <class Real>
DEM_FN void add(DepthSums<Real>& sums, const DepthSums<Real>& more) {
    sums = {sums.force + more.force, sums.energy + more.energy, minOf(sums.nearest, more.nearest),
            sums.arm + more.arm};
}

/// `tangent`: of the collider from the particle's centre.
template <class Real>
DEM_FN Pressed<Real> pressedSphere(const OwnParticle<Real>& own, Real drift,
                                   const TangentPlane<Real>& tangent) {
    Pressed<Real> at;
    at.normal = xyz(tangent.plane);
    at.depth = own.constants.floor_radius - tangent.distance;
    at.gap = -at.depth;
    at.arm = -tangent.distance * at.normal;
    const Real opening = dot(xyz(own.state.velocity), at.normal);
    at.change = overlapChange(at.depth, overlapBefore(at.depth, opening, drift));
    return at;
}
/// What a point of depth -distance leaves to the ledger; `opening`: m/s.
template <class Real>
DEM_FN void addChange(OverlapChange<Real>& change, Real distance, Real opening, Real dt) {
    add(change, Real(kCornerShare), overlapChange(-distance, overlapBefore(-distance, opening, dt)));
}

/// Calls visit(corner, number) for every kStride-th from `first` on, below `last`. kAtOnce are read together,
/// since on a GPU the way to each is long. The last of them are filled up with numbers from `last` on, and
/// with corners that are none: a branch costs more. So is what comes after the corners, of which there must
/// be one.
template <uint32_t kStride, uint32_t kAtOnce, class Real, class Visit>
DEM_FN void forEachCorner(const OwnCorners<Real>& corners, uint32_t first, uint32_t last,
                          const Visit& visit) {
    const auto count = static_cast<uint32_t>(corners.from_seed.size());
    for (; first < last; first += kAtOnce * kStride) {
        Vec3<Real> corner[kAtOnce];
        for (uint32_t k = 0; k < kAtOnce; ++k) {
            const uint32_t number = first + k * kStride;
            corner[k] = xyz(corners.from_seed[number < count ? number : 0]);
        }
        for (uint32_t k = 0; k < kAtOnce; ++k) visit(corner[k], first + k * kStride);
    }
}

/// Of the sum of what points press with, what they push with together at least, for a normal to be told.
inline constexpr double kLeastPush = 0.05;

/// From the sums of a cell's corners, their arms seen from the cell. `push`: what they press with along
/// `normal`, on a plane sums.force. Springs and depth give that push, and what all points hold.
template <bool kHertz, class Real>
DEM_FN Pressed<Real> pressedBy(const DepthSums<Real>& sums, Real push, const Vec3<Real>& normal,
                               const Quat<Real>& turned, const OverlapChange<Real>& change) {
    Pressed<Real> at;
    at.normal = normal;
    at.gap = sums.nearest;
    at.rolling = Real(kCornerRolling);
    at.change = change;
    if (!sums.touches()) return at;
    at.arm = rotate(turned, sums.meanArm());
    at.depth = sums.energy / maxOf(push, Real(kLeastPush) * sums.force);
    at.springs = Real(kCornerShare) * push / pressOf<kHertz>(at.depth);
    return at;
}

/// Corners on a plane, whose normal is turned into the cell's frame rather than its corners out of it: a
/// fifth of the work.
template <bool kLedger, bool kHertz, class Real>
DEM_FN Pressed<Real> pressedOnPlane(const OwnParticle<Real>& own, const SeenCell<Real>& cell,
                                    const TangentPlane<Real>& tangent) {
    const Vec3<Real> normal = xyz(tangent.plane), up = rotate(conjugate(cell.turned), normal);
    const Vec3<Real> rising = rotate(conjugate(cell.turned), cross(normal, xyz(own.state.spin)));
    const Real opening = dot(xyz(own.state.velocity), normal);
    DepthSums<Real> sums;
    OverlapChange<Real> change;
    const auto count = static_cast<uint32_t>(cell.corners.from_seed.size());
    forEachCorner<1, 4>(cell.corners, 0, count, [&](const Vec3<Real>& corner, uint32_t number) {
        const Real distance = tangent.distance + dot(up, corner);
        addDepth<kHertz>(sums, number < count ? distance : Real(kFarAway), corner);
        if constexpr (kLedger)
            if (number < count) addChange(change, distance, opening + dot(rising, corner), cell.drift);
    });
    return pressedBy<kHertz>(sums, sums.force, normal, cell.turned, change);
}

}  // namespace demolish
