// SPDX-License-Identifier: Apache-2.0
// The way back from vertex_packing.h; the same bits on host and device.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/vector.h"

namespace demolish {

/// A direction from packOctahedral(), unit.
DEM_FN Vec3<float> unpackOctahedral(uint32_t packed) {
    const auto part = [](uint32_t bits) {
        return static_cast<float>(static_cast<int16_t>(static_cast<uint16_t>(bits))) / 32767.0f;
    };
    const float u = part(packed & 0xffffu), v = part(packed >> 16);
    const float au = u < 0.0f ? -u : u, av = v < 0.0f ? -v : v;
    Vec3<float> n{u, v, 1.0f - au - av};
    if (n.z < 0.0f) {
        n.x = (1.0f - av) * (u < 0.0f ? -1.0f : 1.0f);
        n.y = (1.0f - au) * (v < 0.0f ? -1.0f : 1.0f);
    }
    return normalized(n);
}

}  // namespace demolish
