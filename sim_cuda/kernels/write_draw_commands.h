// SPDX-License-Identifier: Apache-2.0
// Counts for the indirect draws, from the ends of the scans: the host never learns them.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

struct WriteDrawCommands {
    Span<const uint32_t> first_index;     ///< scan over faces; the last element is the sum
    Span<const uint32_t> crack_place;     ///< scan over crack edges
    Span<const uint32_t> first_exterior;  ///< scan over the triangles of the mesh
    size_t index_capacity, crack_capacity, exterior_capacity;
    Span<DrawCommands> out;

    DEM_FN void operator()(uint32_t) const {
        constexpr uint32_t kCornersOfRibbon = 6;
        const uint32_t all = first_index[first_index.size() - 1], shown = crack_place[crack_place.size() - 1];
        const uint32_t indices = all <= index_capacity ? all : 0;  // never draw what was not written
        const uint32_t cracks = shown <= crack_capacity ? shown : static_cast<uint32_t>(crack_capacity);
        const uint32_t outside = first_exterior[first_exterior.size() - 1];
        const uint32_t exterior = outside <= exterior_capacity ? outside : 0;
        out[0] = {{indices, 1, 0, 0, 0}, {kCornersOfRibbon, cracks, 0, 0, 0}, {exterior, 1, 0, 0, 0}};
    }
};

}  // namespace demolish
