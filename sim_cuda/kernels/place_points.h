// SPDX-License-Identifier: Apache-2.0
// Moved points of the outside are laid onto the mesh, and what stands on them is told.
#pragma once
#include "sim_cuda/kernels/surface_walk.h"

namespace demolish {

/// Where a point that was sent somewhere comes to lie: on the mesh, or on the line of its sharp edge.
struct LayOnOutside {
    OutsideMesh mesh;

    DEM_FN Vec3<float> operator()(uint32_t p, const Vec3<float>& wanted) const {
        const OutsidePoint& point = mesh.points[p];
        if (point.kind != SlideKind::kPlane) return wanted;
        const SurfaceWalk walk{mesh.triangles};
        return walk.pointAt(walk.find(point.triangle, wanted, false));
    }
};

struct PlacePoints {
    LayOnOutside lay;
    Span<const Float3> shift;
    Span<Float3> start;                      ///< where points were before this update
    Span<Float3> position, position_before;  ///< both are written

    DEM_FN void operator()(uint32_t p) const {
        const Float3 old = position[p];
        start[p] = old;
        const Float3 laid = toFloat3(lay(p, toVec3(old) + toVec3(shift[p])));
        position[p] = laid;
        position_before[p] = laid;
    }
};

/// After all corrections: everything that hangs on a moved point.
struct FinishPoints {
    OutsideMesh mesh;
    Span<const Float3> position;
    Span<Float3> position_before, shift, shift_before;  ///< made ready for the next update
    Span<Float3> pool, pool_before;
    Span<uint8_t> changed;  ///< 1: since the outside was written last

    DEM_FN void operator()(uint32_t p) const {
        const Float3 now = position[p];
        position_before[p] = now;
        shift[p] = {};
        shift_before[p] = {};
        changed[p] = 1;
        if (const uint32_t v = mesh.points[p].pool; v != kNoPool) {
            pool[v] = now;
            pool_before[v] = now;
        }
    }
};

}  // namespace demolish
