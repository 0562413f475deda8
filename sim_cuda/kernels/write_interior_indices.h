// SPDX-License-Identifier: Apache-2.0
// Triangles of the exposed faces: side a as it stands, side b turned round.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

struct WriteInteriorIndices {
    Span<const InteriorFace> faces;
    Span<const uint16_t> face_indices;
    Span<const uint8_t> face_state;
    Span<const uint32_t> first_vertex, first_index;  ///< of each face in the streams
    size_t vertex_capacity;
    Span<uint32_t> out;

    DEM_FN void operator()(uint32_t f) const {
        if (face_state[f] == kFaceHidden || first_index[f + 1] > out.size()) return;
        if (first_vertex[f + 1] > vertex_capacity) return;
        const InteriorFace face = faces[f];
        const uint32_t side_a = first_vertex[f], side_b = side_a + face.vertex_count;
        uint32_t to_a = first_index[f], to_b = to_a + face.index_count;
        for (uint32_t i = face.first_index; i < face.first_index + face.index_count; i += 3) {
            const uint32_t u = face_indices[i], v = face_indices[i + 1], w = face_indices[i + 2];
            out[to_a++] = side_a + u;
            out[to_a++] = side_a + v;
            out[to_a++] = side_a + w;
            out[to_b++] = side_b + u;
            out[to_b++] = side_b + w;
            out[to_b++] = side_b + v;
        }
    }
};

}  // namespace demolish
