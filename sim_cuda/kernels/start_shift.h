// SPDX-License-Identifier: Apache-2.0
// How far points of cracks have to go in this update, and which cells that stirs.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/outside_mesh.h"
#include "sim_cuda/kernels/break_waves.h"

namespace demolish {

/// Bits of a cell.
inline constexpr uint32_t kCellStirred = 1, kCellBeside = 2;

/// One thread a point on the border of cells.
struct StartShift {
    /// Over h: less is not worth the work.
    static constexpr float kLeast = 0.01f;
    /// Of the waves of a face: what slides over a curved outside bridges it with other chords, which costs
    /// volume.
    static constexpr float kRimWaves = 0.4f;

    OutsideMesh mesh;
    Span<const uint32_t> border;
    Span<const RimLink> link;
    Span<const Float3> place, position;  ///< wanted without waves, present
    Span<Float3> tried;                  ///< where each set out for last: at rest before
    Span<Float3> shift, shift_before;    ///< both are written; 0 before
    Span<uint32_t> stirred;              ///< bits of cells

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t p = border[i];
        if (link[p].kind == RimKind::kNone || link[p].fixed != 0) return;
        const OutsidePoint& point = mesh.points[p];
        const Vec3<float> wanted = wantedPlace(p), way = alongOutside(point, wanted - toVec3(position[p]));
        const float least = kLeast * point.spacing;
        if (length2(way) < least * least) return;
        // A hairline that did not get there would not get there now: what was taken back would be again.
        if (link[p].kind == RimKind::kHairline && length2(wanted - toVec3(tried[p])) < least * least) return;
        tried[p] = toFloat3(wanted);
        shift[p] = toFloat3(way);
        shift_before[p] = toFloat3(way);
        for (uint32_t c = mesh.crack_start[p]; c < mesh.crack_start[p + 1]; ++c) {
            const CrackEdge edge = mesh.edges[mesh.cracks[c].edge];
            atomicOrU32(&stirred[edge.cell_a], kCellStirred);
            atomicOrU32(&stirred[edge.cell_b], kCellStirred);
        }
    }

  private:
    DEM_FN Vec3<float> wantedPlace(uint32_t p) const {
        const OutsidePoint& point = mesh.points[p];
        const Vec3<float> rest = toVec3(point.position);
        const Vec3<float> waves = breakWaves(rest, point.spacing, point.waves);
        const Vec3<float> slid =
            axpy(kRimWaves * crackSmoothing(link[p].smallest).waves, waves, toVec3(place[p]) - rest);
        return rest + atMost(point.reach, alongOutside(point, slid));
    }
};

/// One thread a crack edge: cells beside a stirred one.
struct StirNeighbours {
    Span<const CrackEdge> edges;
    Span<uint32_t> stirred;

    DEM_FN void operator()(uint32_t e) const {
        const CrackEdge edge = edges[e];
        const uint32_t a = atomicLoadU32(&stirred[edge.cell_a]), b = atomicLoadU32(&stirred[edge.cell_b]);
        if ((a & kCellStirred) != 0 && (b & kCellBeside) == 0)
            atomicOrU32(&stirred[edge.cell_b], kCellBeside);
        if ((b & kCellStirred) != 0 && (a & kCellBeside) == 0)
            atomicOrU32(&stirred[edge.cell_a], kCellBeside);
    }
};

/// Which points move in this update: those of cracks that have a shift, and what lies in stirred cells and
/// beside them. One thread a point.
struct ChooseMovingPoints {
    OutsideMesh mesh;
    Span<const RimLink> link;
    Span<const Float3> shift;
    Span<const uint32_t> stirred;
    Span<uint32_t> moves;  ///< 0 or 1

    DEM_FN void operator()(uint32_t p) const { moves[p] = isMoved(p) ? 1 : 0; }

  private:
    DEM_FN bool isMoved(uint32_t p) const {
        const OutsidePoint& point = mesh.points[p];
        if (point.kind == SlideKind::kNone || link[p].fixed != 0) return false;
        if (link[p].kind != RimKind::kNone) return length2(toVec3(shift[p])) > 0;
        bool near = stirred[point.cell] != 0;
        for (uint32_t c = mesh.crack_start[p]; c < mesh.crack_start[p + 1] && !near; ++c) {
            const CrackEdge& edge = mesh.edges[mesh.cracks[c].edge];
            near = stirred[edge.cell_a] != 0 || stirred[edge.cell_b] != 0;
        }
        return near;
    }
};

}  // namespace demolish
