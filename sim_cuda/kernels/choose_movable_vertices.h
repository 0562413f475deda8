// SPDX-License-Identifier: Apache-2.0
// Which pool vertices may be bent: those on newly exposed faces that neither lie on the outside nor were
// shown before.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

struct ChooseMovableVertices {
    PoolCorners corners;
    Span<const uint8_t> face_state;
    Span<const uint8_t> surface_distance;  ///< in edges; 0 on the outside
    Span<uint8_t> movable;

    DEM_FN void operator()(uint32_t v) const {
        bool fresh = false, shown_before = surface_distance[v] == 0;
        for (uint32_t c = corners.start[v]; c < corners.start[v + 1] && !shown_before; ++c) {
            const uint8_t state = face_state[corners.face[c]];
            fresh = fresh || state == kFaceNew;
            shown_before = state == kFaceOld;
        }
        movable[v] = fresh && !shown_before ? 1 : 0;
    }
};

}  // namespace demolish
