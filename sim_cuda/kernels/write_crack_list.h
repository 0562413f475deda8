// SPDX-License-Identifier: Apache-2.0
// The crack edges that show, in ascending order, and how wide their cracks are at both ends.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/data/outside_mesh.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish {

struct WriteCrackList {
    Span<const uint32_t> place;  ///< exclusive scan of "shown"
    OutsideMesh mesh;
    Span<const ExteriorHome> home;
    Span<const RimLink> link;
    Span<const Float3> position;    ///< of the outside's points
    Span<const uint32_t> fragment;  ///< slot of each particle
    Span<const float> opening;      ///< m, of each bond: MeasureOpenings
    Span<CrackLine> out;

    /// Broken faces do not fit again: they stay so many spacings h apart, somewhat more than
    /// they are rough (RoughenPoolVertices): with 0.06 a cracked wolf showed nothing.
    static constexpr float kUnfit = 0.16f;
    /// A hairline widens from nothing over so many spacings h.
    static constexpr float kTaper = 2;
    /// Edges that are looked at: many short ones in a row are a line that goes on.
    static constexpr uint32_t kMostEdges = 12;

    DEM_FN void operator()(uint32_t k) const {
        if (place[k + 1] == place[k] || place[k] >= out.size()) return;
        const uint32_t a = home[mesh.edges[k].vertex_0].point, b = home[mesh.edges[k].vertex_1].point;
        const bool apart = isApart(k);
        out[place[k]] = {k, packHalf2(widthAt(a, apart), widthAt(b, apart))};
    }

  private:
    DEM_FN bool isApart(uint32_t edge) const {
        return fragment[mesh.edges[edge].cell_a] != fragment[mesh.edges[edge].cell_b];
    }
    /// m, the same for all hairlines that meet at a point, and for all borders of fragments: the mean of the
    /// bonds that have opened there.
    DEM_FN float widthAt(uint32_t point, bool apart) const {
        float sum = 0, open = 0;
        for (uint32_t c = mesh.crack_start[point]; c < mesh.crack_start[point + 1]; ++c) {
            const uint32_t edge = mesh.cracks[c].edge, bond = mesh.edges[edge].bond;
            if (place[edge + 1] == place[edge] || bond == kNoBond || isApart(edge) != apart) continue;
            sum += opening[bond];
            open += 1;
        }
        return open > 0 ? taperAt(point) * (sum / open + kUnfit * mesh.points[point].spacing) : 0;
    }
    /// Share of the whole width.
    DEM_FN float taperAt(uint32_t point) const {
        const RimLink at = link[point];
        if (at.kind != RimKind::kHairline || at.degree > 2) return 1;
        const float whole = kTaper * mesh.points[point].spacing;
        float way = at.degree == 1 ? 0 : whole;
        for (uint32_t side = 0; side < at.degree && way > 0; ++side) {
            const float other = wayToEnd(point, at.next[side], whole);
            way = other < way ? other : way;
        }
        return way / whole;
    }
    /// m, along the line from `before` over `here`; `whole` where the end is farther, or there is none.
    DEM_FN float wayToEnd(uint32_t before, uint32_t here, float whole) const {
        float way = 0;
        for (uint32_t edge = 0; edge < kMostEdges; ++edge) {
            way += length(toVec3(position[here]) - toVec3(position[before]));
            const RimLink at = link[here];
            if (way >= whole || at.kind != RimKind::kHairline || at.degree > 2) return whole;
            if (at.degree == 1) return way;
            const uint32_t next = at.next[0] == before ? at.next[1] : at.next[0];
            before = here;
            here = next;
        }
        return whole;
    }
};

}  // namespace demolish
