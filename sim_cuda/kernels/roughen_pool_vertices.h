// SPDX-License-Identifier: Apache-2.0
// Geometric roughness of a fresh crack surface: noise of the rest position, fading towards the outside
// (geometry.md 4 b).
#pragma once
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/kernels/spread_surface_distance.h"
#include "sim_cuda/physics/value_noise.h"

namespace demolish {

/// Of one vertex that has been relaxed; `position` and `before` become alike.
struct RoughenPoolVertices {
    Span<const uint8_t> surface_distance;
    Span<const uint32_t> pieces_there;
    Span<const Float3> rest;
    Span<const float> spacing;
    Span<Float3> position, before;

    DEM_FN void operator()(uint32_t v) const {
        const float h = spacing[v], rough = faceSmoothing(pieces_there[v]).rough;
        const float inside = static_cast<float>(surface_distance[v]) / static_cast<float>(kInnerDistance);
        const Vec3<float> noise = roughnessNoise((1.0f / (kRoughnessWave * h)) * toVec3(rest[v]));
        position[v] = toFloat3(axpy(rough * inside * h, noise, toVec3(position[v])));
        before[v] = position[v];
    }
};

}  // namespace demolish
