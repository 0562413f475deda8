// SPDX-License-Identifier: Apache-2.0
// The corners of a cell on a collider that is no plane, and a sphere within the cell, since edges of the
// collider reach between corners. Most corners do not touch: a first look tells which do not, by their
// distance alone, and only the others ask for a normal. On a GPU threads whose cells lie beside each other
// then take as long as the one with most corners that touch, not as all corners together. Where there is a
// thread for one or two corners, each looks once and closely.
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
template <class Real>
struct PointsPressed {
    DepthSums<Real> sums;        ///< arms in the cell's frame
    Vec3<Real> normal;           ///< sum of normals, each by what it presses with
    Vec3<Real> turning;          ///< likewise of arms x normals, m
    OverlapChange<Real> change;  ///< for the ledger
};

/// A point of a cell as a collider has it.
template <class Real>
struct PointAt {
    Away<Real> away;
    Vec3<Real> arm;      ///< m, from the cell's centre, in its frame
    Vec3<Real> turning;  ///< m, arm x away.out, in the frame of the latter
    Real opening{};      ///< m/s, for the ledger
};
/// One point more.
template <bool kLedger, bool kHertz, class Real>
DEM_FN void addPoint(PointsPressed<Real>& at, const PointAt<Real>& point, Real drift) {
    const Real force = addDepth<kHertz>(at.sums, point.away.distance, point.arm);
    at.normal = axpy(force, point.away.out, at.normal);
    at.turning = axpy(force, point.turning, at.turning);
    if constexpr (kLedger) addChange(at.change, point.away.distance, point.opening, drift);
}
template <bool kLedger, class Real>
DEM_FN void add(PointsPressed<Real>& at, const PointsPressed<Real>& more) {
    add(at.sums, more.sums);
    at.normal = at.normal + more.normal;
    at.turning = at.turning + more.turning;
    if constexpr (kLedger) add(at.change, Real(1), more.change);
}
/// Those of the lane whose number differs in bit `bit`.
template <bool kLedger, class Real, class Lanes>
DEM_FN PointsPressed<Real> across(const Lanes& lanes, uint32_t bit, const PointsPressed<Real>& own) {
    const auto vector = [&](const Vec3<Real>& v) {
        return Vec3<Real>{lanes.across(bit, v.x), lanes.across(bit, v.y), lanes.across(bit, v.z)};
    };
    const DepthSums<Real>& sums = own.sums;
    PointsPressed<Real> other{{lanes.across(bit, sums.force), lanes.across(bit, sums.energy),
                               lanes.across(bit, sums.nearest), vector(sums.arm)},
                              vector(own.normal),
                              vector(own.turning),
                              {}};
    if constexpr (kLedger)
        other.change = {lanes.across(bit, own.change.crossed), lanes.across(bit, own.change.held)};
    return other;
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

/// Shapes as the loop over corners sees them. away(): `out` is what the distance grows by. `at`: from begin()
/// along its axes, by shift() farther, in units of unit(). firstLook(): m, not above 0 where it takes away()
/// to tell.
template <class Real>
struct CornersOnBox {
    const ColliderRows<Real>& rows;
    DEM_FN Vec3<Real> begin() const { return xyz(rows.row[3]); }
    DEM_FN Vec3<Real> axis(uint32_t k) const { return xyz(rows.row[k]); }
    DEM_FN Real shift(uint32_t) const { return Real(0); }
    DEM_FN Real unit() const { return Real(1); }
    DEM_FN Real firstLook(const Vec3<Real>& at) const { return away(at).distance; }
    DEM_FN Away<Real> fromCentre(const Vec3<Real>&, const Away<Real>& away) const { return away; }
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
    DEM_FN Away<Real> fromCentre(const Vec3<Real>&, const Away<Real>& away) const { return away; }
    DEM_FN Away<Real> away(const Vec3<Real>& at) const { return awayFromRound(rows.row, at); }
};
/// In steps of its grid, from its first node.
template <class Real>
struct CornersOnMesh {
    const ColliderRows<Real>& rows;
    DEM_FN Vec3<Real> begin() const { return xyz(rows.row[3]); }
    DEM_FN Vec3<Real> axis(uint32_t k) const { return gridAxis(rows, k); }
    DEM_FN Real shift(uint32_t k) const { return gridShift(rows, k); }
    DEM_FN Real unit() const { return stepOf(rows.row[3]); }
    DEM_FN Real firstLook(const Vec3<Real>& at) const { return fieldAt(rows, gridPlace(rows, at)).w; }
    /// Beyond the grid no corner touches, so that the distance at its rim is as good. `out` is the gradient
    /// of the interpolated distance, whose length is not 1 where the nearest way off changes from node to
    /// node: else the push would give more or less than it has cost to press the corner in.
    DEM_FN Away<Real> away(const Vec3<Real>& at) const {
        const Vec4<Real> field = fieldAt(rows, gridPlace(rows, at));
        return {xyz(field), field.w};
    }
    DEM_FN Away<Real> fromCentre(const Vec3<Real>& at, const Away<Real>& away) const {
        return beyondRim(rows, gridPlace(rows, at), uphill(away.out, away.distance));
    }
};

/// Corners are added up in so many parts, corner k in part k mod kCornerParts, and the parts by halves: the
/// second half to the first, and so on. As many threads may share them, or fewer, with the same bits.
inline constexpr uint32_t kCornerParts = 16;

/// Bit k: corner k, one of this lane's, may touch. What surely does not is only passed.
template <class Real, class Shape, class Lanes>
DEM_FN uint32_t cornersThatMayTouch(const OwnCorners<Real>& corners, const AxesInCell<Real>& axes,
                                    const Shape& shape, const Lanes& lanes, Real& nearest) {
    static_assert(kMostCorners <= 32);
    const auto count = static_cast<uint32_t>(corners.from_seed.size());
    uint32_t touching = 0;
    forEachCorner<Lanes::kCount, 4>(
        corners, lanes.lane, count, [&](const Vec3<Real>& corner, uint32_t number) {
            const Real distance = shape.unit() * shape.firstLook(axes.along(corner));
            const bool present = number < count;
            const bool off = distance > Real(0);
            nearest = minOf(nearest, present && off ? distance : Real(kFarAway));
            touching |= present && !off ? 1u << number : 0;
        });
    return touching;
}

/// What several threads have found of a cell on a shape.
template <class Real>
struct ShapeFound {
    PointsPressed<Real> points;
    Away<Real> centre{{}, Real(kFarAway)};  ///< of the particle, along the collider's axes
    bool has_centre = false;                ///< it is this thread that has looked at it
};

/// Looks at single corners and adds them up.
template <bool kLedger, bool kHertz, class Real, class Shape>
class CornerLook {
  public:
    DEM_FN CornerLook(const Shape& shape, const CellPose<Real>& cell)
        : shape_(shape), cell_(cell), axes_(axesInCell(shape, cell)) {
        const Quat<Real> back = conjugate(cell.seen.turned);
        if constexpr (kLedger) {
            velocity_ = rotate(back, cell.velocity);
            spin_ = rotate(back, cell.spin);
        }
    }
    DEM_FN const AxesInCell<Real>& axes() const { return axes_; }
    /// `corner`: in the cell's frame; one that is not present adds nothing. Gives what the shape says of it.
    DEM_FN Away<Real> press(PointsPressed<Real>& part, const Vec3<Real>& corner, bool present) const {
        const Vec3<Real> at = axes_.along(corner);
        const Away<Real> away = shape_.away(at);
        Real opening{};
        if constexpr (kLedger) opening = dot(velocity_ + cross(spin_, corner), axes_.inCell(away.out));
        const Real distance = present ? shape_.unit() * away.distance : Real(kFarAway);
        const Vec3<Real> turning = shape_.unit() * cross(at - axes_.centre, away.out);
        addPoint<kLedger, kHertz>(part, {{away.out, distance}, corner, turning, opening}, cell_.seen.drift);
        return away;
    }
    DEM_FN Away<Real> centre(const Away<Real>& away) const {
        return shape_.fromCentre(axes_.along(Vec3<Real>{}), away);
    }

  private:
    const Shape& shape_;
    const CellPose<Real>& cell_;
    AxesInCell<Real> axes_;
    Vec3<Real> velocity_, spin_;  ///< for the ledger, in the cell's frame
};

/// A thread for each part: all its corners closely, which takes as long as a few do, and the particle's
/// centre as if it were a corner more.
template <class Look, class Real>
DEM_FN ShapeFound<Real> lookOnce(const Look& look, const OwnCorners<Real>& corners, uint32_t part) {
    ShapeFound<Real> found;
    const auto count = static_cast<uint32_t>(corners.from_seed.size());
    forEachCorner<kCornerParts, 2>(corners, part, count + 1, [&](const Vec3<Real>& corner, uint32_t number) {
        const bool present = number < count;
        const Away<Real> away = look.press(found.points, present ? corner : Vec3<Real>{}, present);
        if (number != count) return;
        found.centre = look.centre(away);
        found.has_centre = true;
    });
    return found;
}
/// Fewer threads: those corners closely that `touching` has.
template <bool kLedger, class Look, class Real, class Lanes>
DEM_FN PointsPressed<Real> lookTwice(const Look& look, const OwnCorners<Real>& corners, const Lanes&,
                                     uint32_t touching) {
    constexpr uint32_t kParts = kCornerParts / Lanes::kCount;
    PointsPressed<Real> parts[kParts];
    uint32_t used = 0;
    for (; touching != 0; touching &= touching - 1) {
        const uint32_t number = lowestBit(touching), k = number / Lanes::kCount % kParts;
        PointsPressed<Real> part;
        if ((used >> k & 1) != 0) part = parts[k];
        look.press(part, xyz(corners.from_seed[number]), true);
        parts[k] = part;
        used |= 1u << k;
    }
    for (uint32_t half = kParts / 2; half > 0; half /= 2)
        for (uint32_t k = 0; k < half; ++k)
            if ((used >> (k + half) & 1) != 0) {
                add<kLedger>(parts[k], parts[k + half]);
                used |= 1u << k;
            }
    return parts[0];
}

template <bool kLedger, bool kHertz, class Real, class Shape, class Lanes>
DEM_FN ShapeFound<Real> cornersOn(const Shape& shape, const CellPose<Real>& cell, const Lanes& lanes) {
    const OwnCorners<Real>& corners = cell.seen.corners;
    const CornerLook<kLedger, kHertz, Real, Shape> look(shape, cell);
    ShapeFound<Real> found;
    if constexpr (Lanes::kCount == kCornerParts) {
        found = lookOnce(look, corners, lanes.lane);
    } else {
        Real nearest = Real(kFarAway);
        // The ledger wants to know of corners that have come off as well.
        static_assert(!kLedger || Lanes::kCount == 1);
        const uint32_t touching = kLedger ? lowBits(static_cast<uint32_t>(corners.from_seed.size()))
                                          : cornersThatMayTouch(corners, look.axes(), shape, lanes, nearest);
        found.points = lookTwice<kLedger>(look, corners, lanes, touching);
        found.points.sums.nearest = minOf(found.points.sums.nearest, nearest);
    }
    for (uint32_t half = Lanes::kCount / 2; half > 0; half /= 2)
        add<kLedger>(found.points, across<kLedger>(lanes, half, found.points));
    const auto turnedOutOf = [&](const Vec3<Real>& sum) {
        return rotate(cell.seen.turned, look.axes().inCell(sum));
    };
    found.points.normal = turnedOutOf(found.points.normal);
    found.points.turning = turnedOutOf(found.points.turning);
    return found;
}

/// `rows`: by their address on a GPU too, where kernels hold them as __grid_constant__. Apart: only what is
/// near such a collider pays for it, also in registers.
template <bool kLedger, bool kHertz, class Real, class Lanes>
DEM_APART ShapeFound<Real> cornersOnShape(const ColliderRows<Real>& rows, Handed<CellPose<Real>> cell,
                                          Lanes lanes) {
    if (rows.shape == ColliderShape::kMesh)
        return cornersOn<kLedger, kHertz>(CornersOnMesh<Real>{rows}, cell, lanes);
    if (rows.shape == ColliderShape::kRound)
        return cornersOn<kLedger, kHertz>(CornersOnRound<Real>{rows}, cell, lanes);
    return cornersOn<kLedger, kHertz>(CornersOnBox<Real>{rows}, cell, lanes);
}

/// From its own state.
template <class Real>
DEM_FN CellPose<Real> poseOf(const OwnParticle<Real>& own, const SeenCell<Real>& cell) {
    const LoadedState<Real>& state = own.state;
    return {xyz(state.position), lowPart(state.position, state.velocity, state.spin), cell,
            xyz(state.velocity), xyz(state.spin)};
}

/// `points`: of the cell's corners; `tangent`: from the particle's centre. What lies across an edge is pushed
/// by both faces at once: each corner pushes along its own normal, so that the push is less than their sum
/// and may turn the cell about it, and what the springs hold is what it has taken to press them in.
template <bool kLedger, bool kHertz, class Real>
DEM_FN Pressed<Real> pressedOnShape(PointsPressed<Real> points, const OwnParticle<Real>& own,
                                    const SeenCell<Real>& cell, const TangentPlane<Real>& tangent) {
    const Vec3<Real> out = xyz(tangent.plane), down = rotate(conjugate(cell.turned), -out);
    // The sphere is pushed towards its centre.
    addPoint<kLedger, kHertz>(points,
                              {{out, tangent.distance - cell.corners.inner_radius},
                               tangent.distance * down,
                               {},
                               dot(xyz(own.state.velocity), out)},
                              cell.drift);
    const Real push = length(points.normal), least = Real(kLeastPush) * points.sums.force;
    const Vec3<Real> normal = push > least ? (Real(1) / push) * points.normal : out;
    Pressed<Real> at = pressedBy<kHertz>(points.sums, push, normal, cell.turned, points.change);
    if (points.sums.touches() && push > least)
        at.couple = (Real(1) / push) * points.turning - cross(at.arm, normal);
    return at;
}

}  // namespace demolish
