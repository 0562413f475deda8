// SPDX-License-Identifier: Apache-2.0
// The corners of a cell on a collider that is no plane, and a sphere within the cell, since edges of the
// collider reach between corners. Most corners do not touch: a first look tells which do not, by their
// distance alone, and only the others ask for a normal. On a GPU threads whose cells lie beside each other
// then take as long as the one with most corners that touch, not as all corners together.
#pragma once
#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/backend/bit_count.h"
#include "sim_cuda/kernels/corner_press.h"

namespace demolish {

/// A cell, as the function below is handed it.
template <class Real>
struct CellPose {
    Vec3<Real> high, low;  ///< m, its particle's centre
    SeenCell<Real> seen;
    Vec3<Real> velocity, spin;  ///< m/s, rad/s: for the ledger
};

/// What the corners of a cell give together.
template <bool kHertz, class Real>
struct PointsPressed {
    DepthSums<kHertz, Real> sums;  ///< arms in the cell's frame
    Vec3<Real> normal;             ///< sum of normals, each by what it presses with
    OverlapChange<Real> change;    ///< for the ledger
};

/// One point more. `out`: unit; `opening`: m/s, for the ledger.
template <bool kLedger, bool kHertz, class Real>
DEM_FN void addPoint(PointsPressed<kHertz, Real>& at, const Away<Real>& away, const Vec3<Real>& arm,
                     Real opening, Real drift) {
    at.normal = axpy(at.sums.add(away.distance, arm), away.out, at.normal);
    if constexpr (kLedger) addChange(at.change, away.distance, opening, drift);
}

/// The axes of a collider as a cell sees them: where a corner lies along them is one matrix away.
template <class Real>
struct AxesInCell {
    Vec3<Real> axis[3];  ///< in the cell's frame
    Vec3<Real> centre;   ///< of the cell, along them
    Real unit{};         ///< m, of what is along them

    DEM_FN Vec3<Real> along(const Vec3<Real>& corner) const {
        return {fromCentre(axis[0], corner, centre.x), fromCentre(axis[1], corner, centre.y),
                fromCentre(axis[2], corner, centre.z)};
    }
    /// Of a direction along the collider's axes.
    DEM_FN Vec3<Real> inCell(const Vec3<Real>& out) const {
        return unit * axpy(out.x, axis[0], axpy(out.y, axis[1], out.z * axis[2]));
    }

  private:
    static DEM_FN Real fromCentre(const Vec3<Real>& axis, const Vec3<Real>& corner, Real centre) {
        return madd(axis.x, corner.x, madd(axis.y, corner.y, madd(axis.z, corner.z, centre)));
    }
};
template <class Shape, class Real>
DEM_FN AxesInCell<Real> axesInCell(const Shape& shape, const CellPose<Real>& cell) {
    const Quat<Real> back = conjugate(cell.seen.turned);
    const Vec3<Real> from_begin = (cell.high - shape.begin()) + cell.low;
    const auto centre = [&](uint32_t k) { return dot(shape.axis(k), from_begin) + shape.shift(k); };
    return {{rotate(back, shape.axis(0)), rotate(back, shape.axis(1)), rotate(back, shape.axis(2))},
            {centre(0), centre(1), centre(2)},
            shape.unit()};
}

/// Shapes as the loop over corners sees them. `at`: from begin() along its axes, by shift() farther, in units
/// of unit(). firstLook(): m, not above 0 where it takes away() to tell.
template <class Real>
struct CornersOnBox {
    const ColliderRows<Real>& rows;
    DEM_FN Vec3<Real> begin() const { return xyz(rows.row[3]); }
    DEM_FN Vec3<Real> axis(uint32_t k) const { return xyz(rows.row[k]); }
    DEM_FN Real shift(uint32_t) const { return Real(0); }
    DEM_FN Real unit() const { return Real(1); }
    DEM_FN Real firstLook(const Vec3<Real>& at) const { return away(at).distance; }
    DEM_FN Away<Real> away(const Vec3<Real>& at) const { return awayFromBox(rows.row, at); }
};
template <class Real>
struct CornersOnRound {
    const ColliderRows<Real>& rows;
    DEM_FN Vec3<Real> begin() const { return xyz(rows.row[0]); }
    DEM_FN Vec3<Real> axis(uint32_t k) const {
        return {Real(k == 0 ? 1 : 0), Real(k == 1 ? 1 : 0), Real(k == 2 ? 1 : 0)};
    }
    DEM_FN Real shift(uint32_t) const { return Real(0); }
    DEM_FN Real unit() const { return Real(1); }
    DEM_FN Real firstLook(const Vec3<Real>& at) const { return away(at).distance; }
    DEM_FN Away<Real> away(const Vec3<Real>& at) const { return awayFromRound(rows.row, at); }
};
/// In steps of its grid, from its first node.
template <class Real>
struct CornersOnMesh {
    const ColliderRows<Real>& rows;
    const Real per_step = Real(1) / stepOf(rows.row[3]);
    DEM_FN Vec3<Real> begin() const { return xyz(rows.row[3]); }
    DEM_FN Vec3<Real> axis(uint32_t k) const { return per_step * xyz(rows.row[k]); }
    DEM_FN Real shift(uint32_t k) const { return per_step * (halfEdgeOf(rows.row[k]) + rows.margin); }
    DEM_FN Real unit() const { return stepOf(rows.row[3]); }
    DEM_FN Real firstLook(const Vec3<Real>& at) const { return distanceWithinGrid(rows, at); }
    DEM_FN Away<Real> away(const Vec3<Real>& at) const { return awayFromMesh(rows, gridPlace(rows, at)); }
};

/// Bit k: corner k may touch. What surely does not is only passed. Lanes share the corners.
template <bool kHertz, class Real, class Shape, class Lanes>
DEM_FN uint32_t cornersThatMayTouch(const OwnCorners<Real>& corners, const AxesInCell<Real>& axes,
                                    const Shape& shape, const Lanes& lanes, DepthSums<kHertz, Real>& sums) {
    static_assert(kMostCorners <= 32);
    uint32_t touching = 0;
    Real nearest = Real(kFarAway);
    forEachCorner(corners, lanes, [&](const Vec3<Real>& corner, uint32_t number, bool present) {
        const Real distance = shape.firstLook(axes.along(corner));
        const bool off = distance > Real(0);
        nearest = minOf(nearest, present && off ? distance : Real(kFarAway));
        touching |= present && !off ? 1u << number : 0;
    });
    sums.pass(lanes.least(nearest));
    return lanes.united(touching);
}

/// The bits that are left without the `count` lowest.
DEM_FN uint32_t withoutLowest(uint32_t bits, uint32_t count) {
    for (uint32_t k = 0; k < count; ++k) bits &= bits - 1;
    return bits;
}

/// A corner that may touch, as its lane has found it.
template <class Real>
struct FoundCorner {
    Away<Real> away{{}, Real(kFarAway)};
    Vec3<Real> arm;
    Real opening{};  ///< m/s, for the ledger

    template <class Lanes>
    DEM_FN FoundCorner from(const Lanes& lanes, uint32_t lane) const {
        const auto same = [&](const Vec3<Real>& v) {
            return Vec3<Real>{lanes.from(lane, v.x), lanes.from(lane, v.y), lanes.from(lane, v.z)};
        };
        return {{same(away.out), lanes.from(lane, away.distance)}, same(arm), lanes.from(lane, opening)};
    }
};

/// Each lane looks at a corner of its own; all of them add all, in the order of corners.
template <bool kLedger, bool kHertz, class Real, class Shape, class Lanes>
DEM_FN PointsPressed<kHertz, Real> cornersOn(const Shape& shape, const CellPose<Real>& cell,
                                             const Lanes& lanes) {
    PointsPressed<kHertz, Real> at;
    const OwnCorners<Real>& corners = cell.seen.corners;
    const Quat<Real>&turned = cell.seen.turned, back = conjugate(turned);
    const AxesInCell<Real> axes = axesInCell(shape, cell);
    const Vec3<Real> velocity = kLedger ? rotate(back, cell.velocity) : Vec3<Real>{},
                     spin = kLedger ? rotate(back, cell.spin) : Vec3<Real>{};
    // The ledger wants to know of corners that have come off as well.
    uint32_t left = kLedger ? lowBits(static_cast<uint32_t>(corners.from_seed.size()))
                            : cornersThatMayTouch(corners, axes, shape, lanes, at.sums);
    for (; left != 0; left = withoutLowest(left, Lanes::kCount)) {
        const uint32_t own = withoutLowest(left, lanes.lane);
        FoundCorner<Real> found;
        found.arm = xyz(corners.from_seed[own != 0 ? lowestBit(own) : 0]);
        const Away<Real> away = shape.away(axes.along(found.arm));
        found.away = {away.out, own != 0 ? away.distance : Real(kFarAway)};
        if constexpr (kLedger) found.opening = dot(velocity + cross(spin, found.arm), axes.inCell(away.out));
        for (uint32_t lane = 0; lane < Lanes::kCount; ++lane) {
            const FoundCorner<Real> next = found.from(lanes, lane);
            addPoint<kLedger>(at, next.away, next.arm, next.opening, cell.seen.drift);
        }
    }
    at.normal = rotate(turned, axes.inCell(at.normal));
    return at;
}

/// `rows`: by their address on a GPU too, where kernels hold them as __grid_constant__. Apart: only what is
/// near such a collider pays for it, also in registers.
template <bool kLedger, bool kHertz, class Real, class Lanes>
DEM_APART PointsPressed<kHertz, Real> cornersOnShape(const ColliderRows<Real>& rows,
                                                     Handed<CellPose<Real>> cell, Lanes lanes) {
    if (rows.shape == ColliderShape::kMesh)
        return cornersOn<kLedger, kHertz>(CornersOnMesh<Real>{rows}, cell, lanes);
    if (rows.shape == ColliderShape::kRound)
        return cornersOn<kLedger, kHertz>(CornersOnRound<Real>{rows}, cell, lanes);
    return cornersOn<kLedger, kHertz>(CornersOnBox<Real>{rows}, cell, lanes);
}

/// `tangent`: from the particle's centre.
template <bool kLedger, bool kHertz, class Real, class Lanes>
DEM_FN Pressed<Real> pressedOnShape(const ColliderRows<Real>& rows, const OwnParticle<Real>& own,
                                    const SeenCell<Real>& cell, const TangentPlane<Real>& tangent,
                                    const Lanes& lanes) {
    const LoadedState<Real>& state = own.state;
    const CellPose<Real> pose{xyz(state.position), lowPart(state.position, state.velocity, state.spin), cell,
                              xyz(state.velocity), xyz(state.spin)};
    PointsPressed<kHertz, Real> points = cornersOnShape<kLedger, kHertz>(rows, pose, lanes);
    const Vec3<Real> out = xyz(tangent.plane), down = rotate(conjugate(cell.turned), -out);
    addPoint<kLedger>(points, {out, tangent.distance - cell.corners.inner_radius}, tangent.distance * down,
                      dot(xyz(state.velocity), out), cell.drift);
    return pressedBy(points.sums, points.sums.touches() ? normalized(points.normal) : out, cell.turned,
                     points.change);
}

}  // namespace demolish
