// SPDX-License-Identifier: Apache-2.0
// Which interior faces show: those whose cells are in different fragments; and how much each writes.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

struct MarkExposedFaces {
    Span<const InteriorFace> faces;
    Span<const uint32_t> fragment;  ///< slot of each particle
    Span<uint8_t> state;
    Span<uint32_t> vertex_count, index_count;  ///< of both sides; 0 while hidden

    DEM_FN void operator()(uint32_t f) const {
        const InteriorFace face = faces[f];
        const bool exposed = fragment[face.cell_a] != fragment[face.cell_b];
        const uint8_t shown = state[f] == kFaceHidden ? kFaceNew : kFaceOld;
        state[f] = exposed ? shown : kFaceHidden;
        vertex_count[f] = exposed ? 2 * face.vertex_count : 0;
        index_count[f] = exposed ? 2 * face.index_count : 0;
    }
};

}  // namespace demolish
