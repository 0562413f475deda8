// SPDX-License-Identifier: Apache-2.0
// Distance of pool vertices from the outside, counted in edges: one more ring a call.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

/// Vertices this many edges from the outside, or more, are rough to the full.
inline constexpr uint8_t kInnerDistance = 3;

struct SpreadSurfaceDistance {
    PoolCorners corners;
    Span<const uint8_t> before;
    Span<uint8_t> after;

    DEM_FN void operator()(uint32_t v) const {
        uint8_t nearest = before[v];
        for (uint32_t c = corners.start[v]; c < corners.start[v + 1]; ++c) {
            const uint8_t next = before[corners.next[c]], previous = before[corners.previous[c]];
            const uint8_t closer = next < previous ? next : previous;
            nearest = closer + 1 < nearest ? static_cast<uint8_t>(closer + 1) : nearest;
        }
        after[v] = nearest;
    }
};

}  // namespace demolish
