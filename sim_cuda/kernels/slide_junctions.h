// SPDX-License-Identifier: Apache-2.0
// Where three lines of cracks meet: the point goes towards where they come from.
#pragma once
#include "sim_cuda/kernels/rim_walk.h"

namespace demolish {

/// One thread a point on the border of cells; before SlideRims of the same kind.
struct SlideJunctions {
    /// Share of the way to the mean of its branches, each followed for one sigma.
    static constexpr float kShare = 0.6f;

    OutsideMesh mesh;
    RimLines lines;
    Span<const uint32_t> border, fragment;
    Span<const uint8_t> bond_broken;
    Span<Float3> place;  ///< of all points of this kind: at rest, or where the junction goes

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t p = border[i];
        if (!lines.isOwn(p)) return;
        const Vec3<float> rest = toVec3(mesh.points[p].position);
        place[p] = mesh.points[p].position;
        const RimLink link = lines.link[p];
        const float sigma = crackSmoothing(link.smallest).line * mesh.points[p].spacing;
        if (link.degree < 3 || sigma <= 0) return;
        Vec3<float> sum;
        float branches = 0;
        for (uint32_t c = mesh.crack_start[p]; c < mesh.crack_start[p + 1]; ++c) {
            const uint32_t first = mesh.cracks[c].other;
            if (!isBranch(mesh.cracks[c].edge)) continue;
            sum = sum + (alongBranch(p, first, sigma) - rest);
            branches += 1.0f;
        }
        const Vec3<float> shift = alongOutside(mesh.points[p], (kShare / branches) * sum);
        place[p] = toFloat3(rest + atMost(mesh.points[p].reach, shift));
    }

  private:
    DEM_FN bool isBranch(uint32_t e) const {
        const CrackEdge edge = mesh.edges[e];
        const bool apart = fragment[edge.cell_a] != fragment[edge.cell_b];
        if (lines.kind == RimKind::kApart) return apart;
        return !apart && edge.bond != kNoBond && bond_broken[edge.bond] != 0;
    }
    /// The point `wanted` m along the branch, or its end.
    DEM_FN Vec3<float> alongBranch(uint32_t p, uint32_t first, float wanted) const {
        uint32_t before = p, now = first;
        Vec3<float> from = lines.at(p), to = lines.at(first);
        float way = 0;
        for (uint32_t step = 0; step < kMostRimSteps; ++step) {
            const float part = length(to - from);
            if (way + part >= wanted) return axpy((wanted - way) / part, to - from, from);
            way += part;
            if (!lines.goesOn(now)) break;
            const uint32_t next = lines.beyond(before, now);
            before = now;
            now = next;
            from = to;
            to = lines.at(now);
        }
        return to;
    }
};

}  // namespace demolish
