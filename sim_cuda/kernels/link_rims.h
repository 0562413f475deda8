// SPDX-License-Identifier: Apache-2.0
// Joins the crack edges that show into lines: which points follow each other, and where lines meet.
#pragma once
#include "sim_cuda/data/outside_mesh.h"

namespace demolish {

/// One thread a point on the border of cells. Borders of fragments come before hairlines: a point of both is
/// of the former, and hairlines end there.
struct LinkRims {
    OutsideMesh mesh;
    Span<const uint32_t> border;         ///< the points
    Span<const uint32_t> fragment;       ///< slot of each particle
    Span<const uint32_t> fragment_size;  ///< cells, by slot
    Span<const uint8_t> bond_broken;
    Span<RimLink> link;
    Span<const Float3> position;  ///< present
    Span<Float3> place;           ///< where each is to be: for now where it is

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t p = border[i];
        place[p] = position[p];
        RimLink made{};
        made.smallest = 0xffffffffu;
        for (uint32_t c = mesh.crack_start[p]; c < mesh.crack_start[p + 1]; ++c) {
            const RimKind kind = kindOf(mesh.edges[mesh.cracks[c].edge]);
            made.kind = static_cast<uint8_t>(kind) > static_cast<uint8_t>(made.kind) ? kind : made.kind;
        }
        if (made.kind != RimKind::kNone) follow(p, made);
        made.fixed = link[p].kind == RimKind::kApart ? 1 : 0;
        link[p] = made;
    }

  private:
    DEM_FN RimKind kindOf(const CrackEdge& edge) const {
        if (fragment[edge.cell_a] != fragment[edge.cell_b]) return RimKind::kApart;
        const bool cracked = edge.bond != kNoBond && bond_broken[edge.bond] != 0;
        return cracked ? RimKind::kHairline : RimKind::kNone;
    }
    DEM_FN void follow(uint32_t p, RimLink& made) const {
        for (uint32_t c = mesh.crack_start[p]; c < mesh.crack_start[p + 1]; ++c) {
            const PointCrack crack = mesh.cracks[c];
            const CrackEdge edge = mesh.edges[crack.edge];
            if (kindOf(edge) != made.kind) continue;
            if (made.degree < 2) made.next[made.degree] = crack.other;
            if (made.degree < 255) ++made.degree;
            const uint32_t a = fragment_size[fragment[edge.cell_a]], b = fragment_size[fragment[edge.cell_b]];
            const uint32_t smaller = a < b ? a : b;
            made.smallest = smaller < made.smallest ? smaller : made.smallest;
        }
    }
};

}  // namespace demolish
