// SPDX-License-Identifier: Apache-2.0
// Which pool vertices may be bent: those on newly exposed faces that neither lie on the outside nor were
// shown before.
#pragma once
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

struct ChooseMovableVertices {
    PoolCorners corners;
    Span<const InteriorFace> faces;
    Span<const uint8_t> face_state;
    Span<const uint8_t> surface_distance;  ///< in edges; 0 on the outside
    Span<const uint32_t> fragment, fragment_size;
    Span<uint32_t> movable;         ///< 0 or 1
    Span<uint32_t> pieces_there;    ///< PiecesThere::word() of a movable vertex
    Span<uint32_t> smallest_there;  ///< slot of the smallest piece there, or kNoPiece

    DEM_FN void operator()(uint32_t v) const {
        bool fresh = false, shown_before = surface_distance[v] == 0;
        PiecesThere pieces;
        for (uint32_t c = corners.start[v]; c < corners.start[v + 1] && !shown_before; ++c) {
            const uint32_t f = corners.face[c];
            const uint8_t state = face_state[f];
            if (state == kFaceHidden) continue;
            fresh = fresh || state == kFaceNew;
            shown_before = state == kFaceOld;
            const uint32_t a = fragment[faces[f].cell_a], b = fragment[faces[f].cell_b];
            pieces.add(fragment_size[a], a);
            pieces.add(fragment_size[b], b);
        }
        movable[v] = fresh && !shown_before ? 1 : 0;
        pieces_there[v] = pieces.word();
        smallest_there[v] = pieces.slot;
    }
};

}  // namespace demolish
