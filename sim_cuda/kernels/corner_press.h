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
    Real depth{};       ///< m, of the points, each by what it presses with; not above 0: none touches
    Real springs{1};    ///< springs of this depth that press as hard
    Real gap{};         ///< m, to the lowest point
    Real rolling{1};    ///< share of the rolling resistance
    OverlapChange<Real> change;  ///< for the ledger
};

/// Depths of points added up, each by what it presses with. kHertz: as StepParams::hertz.
template <bool kHertz, class Real>
class DepthSums {
  public:
    /// `distance`: m, above the surface. Gives the force, in units of the law's constant.
    DEM_FN Real add(Real distance, const Vec3<Real>& arm) {
        nearest_ = minOf(nearest_, distance);
        const Real depth = -distance, force = depth > Real(0) ? forceOf(depth) : Real(0);
        force_ = force_ + force;
        energy_ = madd(force, depth, energy_);
        arm_ = axpy(force, arm, arm_);
        return force;
    }
    /// One that does not press.
    DEM_FN void pass(Real distance) { nearest_ = minOf(nearest_, distance); }
    /// m, above the surface.
    DEM_FN Real nearest() const { return nearest_; }
    DEM_FN bool touches() const { return force_ > Real(0); }
    DEM_FN Real depth() const { return energy_ / force_; }
    DEM_FN Real springs() const { return Real(kCornerShare) * force_ / forceOf(depth()); }
    /// m, in the frame of those that were added.
    DEM_FN Vec3<Real> arm() const { return (Real(1) / force_) * arm_; }

  private:
    static DEM_FN Real forceOf(Real depth) { return kHertz ? depth * squareRoot(depth) : depth; }

    Real force_{}, energy_{}, nearest_{Real(kFarAway)};
    Vec3<Real> arm_;
};

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

/// Calls visit(corner, number, present) for each of a lane's in turn, which are every kCount-th. Four are
/// read at once, since on a GPU the way to each is long. The last four are filled up with corners that are
/// not present: a branch costs more.
template <class Real, class Lanes, class Visit>
DEM_FN void forEachCorner(const OwnCorners<Real>& corners, const Lanes& lanes, const Visit& visit) {
    constexpr uint32_t kAtOnce = 4;
    const auto last = static_cast<uint32_t>(corners.from_seed.size());
    for (uint32_t first = lanes.lane; first < last; first += kAtOnce * Lanes::kCount) {
        Vec3<Real> corner[kAtOnce];
        for (uint32_t k = 0; k < kAtOnce; ++k) {
            const uint32_t number = first + k * Lanes::kCount;
            corner[k] = xyz(corners.from_seed[number < last ? number : first]);
        }
        for (uint32_t k = 0; k < kAtOnce; ++k) {
            const uint32_t number = first + k * Lanes::kCount;
            visit(corner[k], number, number < last);
        }
    }
}

/// From the sums of a cell's corners, their arms seen from the cell.
template <bool kHertz, class Real>
DEM_FN Pressed<Real> pressedBy(const DepthSums<kHertz, Real>& sums, const Vec3<Real>& normal,
                               const Quat<Real>& turned, const OverlapChange<Real>& change) {
    Pressed<Real> at;
    at.normal = normal;
    at.gap = sums.nearest();
    at.rolling = Real(kCornerRolling);
    at.change = change;
    if (!sums.touches()) return at;
    at.arm = rotate(turned, sums.arm());
    at.depth = sums.depth();
    at.springs = sums.springs();
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
    DepthSums<kHertz, Real> sums;
    OverlapChange<Real> change;
    forEachCorner(cell.corners, LaneGroup<1>{}, [&](const Vec3<Real>& corner, uint32_t, bool present) {
        const Real distance = tangent.distance + dot(up, corner);
        sums.add(present ? distance : Real(kFarAway), corner);
        if constexpr (kLedger)
            if (present) addChange(change, distance, opening + dot(rising, corner), cell.drift);
    });
    return pressedBy(sums, normal, cell.turned, change);
}

}  // namespace demolish
