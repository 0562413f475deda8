// SPDX-License-Identifier: Apache-2.0
// Geometric roughness of a fresh crack surface: noise of the rest position, fading towards the outside
// (geometry.md 4 b).
#pragma once
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/kernels/spread_surface_distance.h"
#include "sim_cuda/physics/value_noise.h"

namespace demolish {

/// Amplitude of the first octave over h; its wavelength is h.
inline constexpr float kRoughness = 0.15f;

struct RoughenPoolVertices {
    Span<const uint8_t> movable;
    Span<const uint8_t> surface_distance;
    Span<const Float3> rest;
    Span<const float> spacing;
    Span<Float3> position;

    DEM_FN void operator()(uint32_t v) const {
        if (movable[v] == 0) return;
        const float h = spacing[v];
        const float inside = static_cast<float>(surface_distance[v]) / static_cast<float>(kInnerDistance);
        const Vec3<float> noise = roughnessNoise((1.0f / h) * toVec3(rest[v]));
        position[v] = toFloat3(axpy(kRoughness * inside * h, noise, toVec3(position[v])));
    }
};

}  // namespace demolish
