// SPDX-License-Identifier: Apache-2.0
// The way along a line of cracks on the outside, by its length at rest.
#pragma once
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/outside_mesh.h"

namespace demolish {

/// Lines of one kind. A line goes on through points where two edges of its kind meet, and ends at those that
/// do not move: what was shown before and, for hairlines, borders of fragments.
struct RimLines {
    Span<const OutsidePoint> points;
    Span<const RimLink> link;
    Span<const Float3> place;  ///< of points that do not move, and of junctions that have been moved
    RimKind kind = RimKind::kApart;

    DEM_FN bool isHeld(uint32_t p) const {
        return link[p].fixed != 0 || static_cast<uint8_t>(link[p].kind) > static_cast<uint8_t>(kind);
    }
    DEM_FN bool goesOn(uint32_t p) const {
        return link[p].kind == kind && link[p].degree == 2 && link[p].fixed == 0;
    }
    DEM_FN bool isOwn(uint32_t p) const { return link[p].kind == kind && link[p].fixed == 0; }
    DEM_FN Vec3<float> at(uint32_t p) const {
        return isHeld(p) ? toVec3(place[p]) : toVec3(points[p].position);
    }
    DEM_FN uint32_t beyond(uint32_t from, uint32_t through) const {
        return link[through].next[0] == from ? link[through].next[1] : link[through].next[0];
    }
    /// How far a junction at the end of a line has been moved.
    DEM_FN Vec3<float> shiftOfEnd(uint32_t p) const {
        return isHeld(p) || link[p].kind != kind ? Vec3<float>{}
                                                 : toVec3(place[p]) - toVec3(points[p].position);
    }
};

/// Longest way in edges: very fine meshes make rims of very short ones.
inline constexpr uint32_t kMostRimSteps = 256;

}  // namespace demolish
