// SPDX-License-Identifier: Apache-2.0
// A mesh as a collider: signed distances on a grid, between whose nodes they are trilinear. `high` + `low`:
// the point (data/particles.h), m.
#pragma once
#include "sim_cuda/api/params.h"
#include "sim_cuda/data/collider_rows.h"

namespace demolish {

/// Of a mesh, 10 bits each.
DEM_FN uint32_t packedCounts(const NodeCounts& n) {
    return n.x | n.y << 10 | n.z << 20;
}

/// Where a point lies along one axis of a grid of `nodes` nodes; `at`: in steps from the first.
template <class Real>
struct NodePlace {
    uint32_t node = 0;  ///< the lower one
    Real share{};       ///< 0..1, on the way to the next
    Real beyond{};      ///< steps, outside the grid; 0 within
};
template <class Real>
DEM_FN NodePlace<Real> nodePlace(Real at, uint32_t nodes) {
    const Real inside = at > Real(0) ? minOf(at, Real(nodes - 1)) : Real(0);
    const uint32_t node = minOf(static_cast<uint32_t>(inside), nodes - 2);
    return {node, inside - Real(node), at - inside};
}

/// Trilinear in a cell of eight nodes: value and gradient, in steps.
template <class Real>
DEM_FN Vec4<Real> trilinear(const Span<const float>& steps, uint32_t first, uint32_t row, uint32_t layer,
                            const Vec3<Real>& share) {
    // Along x in each of the four rows, then along y in the two layers, then along z.
    Real value[4], slope[4];
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t at = first + (k & 1) * row + (k >> 1) * layer;
        const Real low = Real(steps[at]);
        slope[k] = Real(steps[at + 1]) - low;
        value[k] = madd(share.x, slope[k], low);
    }
    Real across[2], slope_x[2], slope_y[2];
    for (uint32_t k = 0; k < 2; ++k) {
        slope_y[k] = value[2 * k + 1] - value[2 * k];
        across[k] = madd(share.y, slope_y[k], value[2 * k]);
        slope_x[k] = madd(share.y, slope[2 * k + 1] - slope[2 * k], slope[2 * k]);
    }
    const Real slope_z = across[1] - across[0];
    return {madd(share.z, slope_x[1] - slope_x[0], slope_x[0]),
            madd(share.z, slope_y[1] - slope_y[0], slope_y[0]), slope_z, madd(share.z, slope_z, across[0])};
}

/// The interpolated distance changes by at most the root of 3 times the way.
template <class Real>
DEM_FN Real sureDistance(Real distance) {
    return distance > Real(0) ? Real(0.577) * distance : distance;
}

/// Where a point lies in a mesh's grid.
template <class Real>
struct GridPlace {
    NodePlace<Real> x, y, z;
    uint32_t row = 0, layer = 0;  ///< nodes from one row to the next, and from one layer
    uint32_t first = 0;           ///< the lowest of the eight nodes round it
};
/// `at`: from the grid's first node along its axes, in steps.
template <class Real>
DEM_FN GridPlace<Real> gridPlace(const ColliderRows<Real>& rows, const Vec3<Real>& at) {
    const uint32_t nx = rows.counts & 1023, ny = rows.counts >> 10 & 1023, nz = rows.counts >> 20;
    GridPlace<Real> place{nodePlace(at.x, nx), nodePlace(at.y, ny), nodePlace(at.z, nz), nx, nx * ny, 0};
    place.first = place.z.node * place.layer + place.y.node * nx + place.x.node;
    return place;
}

/// Value and gradient, in steps.
template <class Real>
DEM_FN Vec4<Real> fieldAt(const ColliderRows<Real>& rows, const GridPlace<Real>& at) {
    return trilinear(rows.steps, at.first, at.row, at.layer, Vec3<Real>{at.x.share, at.y.share, at.z.share});
}

/// The way of a gradient.
template <class Real>
DEM_FN Away<Real> uphill(const Vec3<Real>& gradient, Real distance) {
    const Real steep = inverseSqrt(length2(gradient));
    return {steep > Real(0) ? steep * gradient : Vec3<Real>{Real(0), Real(1), Real(0)}, distance};
}
/// At a place in the grid: the way in which the interpolated distance grows, and that, in steps.
template <class Real>
DEM_FN Away<Real> uphillAt(const ColliderRows<Real>& rows, const GridPlace<Real>& at) {
    const Vec4<Real> field = fieldAt(rows, at);
    return uphill(xyz(field), field.w);
}
/// Beyond the grid, from the surface point that is nearest as seen from its rim. `at_rim`: uphillAt(); in m.
template <class Real>
DEM_FN Away<Real> beyondRim(const ColliderRows<Real>& rows, const GridPlace<Real>& at,
                            const Away<Real>& at_rim) {
    const Vec3<Real> beyond{at.x.beyond, at.y.beyond, at.z.beyond};
    const Vec3<Real> away = axpy(at_rim.distance, at_rim.out, beyond);
    const Real squared = length2(away), inverse = inverseSqrt(squared);
    const bool is_beyond = length2(beyond) > Real(0);
    return {is_beyond ? inverse * away : at_rim.out,
            stepOf(rows.row[3]) * (is_beyond ? squared * inverse : at_rim.distance)};
}
template <class Real>
DEM_FN Away<Real> awayFromMesh(const ColliderRows<Real>& rows, const GridPlace<Real>& at) {
    return beyondRim(rows, at, uphillAt(rows, at));
}

/// From the grid's first node along its axes, in steps: a direction's axis and what is added to it.
template <class Real>
DEM_FN Vec3<Real> gridAxis(const ColliderRows<Real>& rows, uint32_t k) {
    return rows.per_step * xyz(rows.row[k]);
}
template <class Real>
DEM_FN Real gridShift(const ColliderRows<Real>& rows, uint32_t k) {
    return rows.per_step * (halfEdgeOf(rows.row[k]) + rows.margin);
}

/// A point in a mesh's grid, from its first node along its axes, in steps.
template <class Real>
DEM_FN Vec3<Real> inGrid(const ColliderRows<Real>& rows, const Vec3<Real>& high, const Vec3<Real>& low) {
    const Vec3<Real> from_begin = (high - xyz(rows.row[3])) + low;
    const auto along = [&](uint32_t k) { return dot(gridAxis(rows, k), from_begin) + gridShift(rows, k); };
    return {along(0), along(1), along(2)};
}

/// Steps by which the nodes round a place differ at most: the diagonal of a cell, and what distances are off.
inline constexpr double kNodesDiffer = 2;
/// m, no more than the interpolated distance, from a single node; beyond the grid 0.
template <class Real>
DEM_APART Real leastDistance(const ColliderRows<Real>& rows, Handed<Vec3<Real>> high,
                             Handed<Vec3<Real>> low) {
    const GridPlace<Real> at = gridPlace(rows, inGrid(rows, high, low));
    const bool within = at.x.beyond == Real(0) && at.y.beyond == Real(0) && at.z.beyond == Real(0);
    return within ? stepOf(rows.row[3]) * (Real(rows.steps[at.first]) - Real(kNodesDiffer)) : Real(0);
}

/// Apart: only what is near a mesh pays for it, also in registers.
template <class Real>
DEM_APART TangentPlane<Real> tangentOfMesh(const ColliderRows<Real>& rows, Handed<Vec3<Real>> high,
                                           Handed<Vec3<Real>> low) {
    const Away<Real> away = awayFromMesh(rows, gridPlace(rows, inGrid(rows, high, low)));
    return tangentWith(turnedOut(rows.row, away.out), away.distance, high, low);
}

}  // namespace demolish
