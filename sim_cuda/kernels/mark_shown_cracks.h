// SPDX-License-Identifier: Apache-2.0
// Which crack edges show on the outside: a hairline where the bond is broken though both cells still hang
// together.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

/// Cells in different fragments show their edge too: a crack that has run through must not vanish before the
/// parts have moved. An edge without a bond cannot crack by itself.
struct MarkShownCracks {
    Span<const CrackEdge> edges;
    Span<const uint32_t> fragment;    ///< slot of each particle
    Span<const uint8_t> bond_broken;  ///< 1: broken
    Span<uint32_t> shown;             ///< 0 or 1

    DEM_FN void operator()(uint32_t k) const {
        const CrackEdge edge = edges[k];
        const bool apart = fragment[edge.cell_a] != fragment[edge.cell_b];
        const bool cracked = edge.bond != kNoBond && bond_broken[edge.bond] != 0;
        shown[k] = apart || cracked ? 1 : 0;
    }
};

}  // namespace demolish
