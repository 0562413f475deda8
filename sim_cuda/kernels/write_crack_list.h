// SPDX-License-Identifier: Apache-2.0
// The crack edges that show, in ascending order, and how far hairlines have tapered at their ends.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/data/outside_mesh.h"

namespace demolish {

struct WriteCrackList {
    Span<const uint32_t> place;  ///< exclusive scan of "shown"
    OutsideMesh mesh;
    Span<const ExteriorHome> home;
    Span<const RimLink> link;
    Span<const Float3> position;  ///< of the outside's points
    Span<uint32_t> out;           ///< crackWord()s

    /// A hairline widens from nothing over so many spacings h.
    static constexpr float kTaper = 2;
    /// Edges that are looked at: many short ones in a row are a line that goes on.
    static constexpr uint32_t kMostEdges = 12;

    DEM_FN void operator()(uint32_t k) const {
        if (place[k + 1] == place[k] || place[k] >= out.size()) return;
        const uint32_t a = home[mesh.edges[k].vertex_0].point, b = home[mesh.edges[k].vertex_1].point;
        out[place[k]] = crackWord(k, lackingAt(a), lackingAt(b));
    }

  private:
    /// Of kTaperSteps.
    DEM_FN uint32_t lackingAt(uint32_t point) const {
        const RimLink at = link[point];
        if (at.kind != RimKind::kHairline || at.degree > 2) return 0;
        const float whole = kTaper * mesh.points[point].spacing;
        float way = at.degree == 1 ? 0 : whole;
        for (uint32_t side = 0; side < at.degree && way > 0; ++side) {
            const float other = wayToEnd(point, at.next[side], whole);
            way = other < way ? other : way;
        }
        return static_cast<uint32_t>(static_cast<float>(kTaperSteps) * (1 - way / whole) + 0.5f);
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
