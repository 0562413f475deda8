// SPDX-License-Identifier: Apache-2.0
// The material's waves on a fresh crack surface (break_waves.h), across it alone: along it they would carry
// what lies near the outside through it. At the rim the outside has waves of its own (StartShift).
#pragma once
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/kernels/break_waves.h"
#include "sim_cuda/kernels/spread_surface_distance.h"

namespace demolish {

/// Of one vertex that has been relaxed. Its neighbours are moving, too: how it lies among them is read from
/// `before`, which is at most a smoothing step older than `position`.
struct WavePoolVertices {
    PoolCorners corners;
    Span<const uint8_t> face_state, surface_distance;
    Span<const uint32_t> pieces_there;
    Span<const Float3> rest;
    Span<const float> spacing, waves;
    Span<const Float3> before;
    Span<Float3> position;

    DEM_FN void operator()(uint32_t v) const {
        const float share = faceSmoothing(pieces_there[v]).waves;
        if (share <= 0 || waves[v] <= 0 || surface_distance[v] == 0) return;
        const float inside =
            static_cast<float>(surface_distance[v] + 1) / static_cast<float>(kInnerDistance + 1);
        const Vec3<float> way = across(v, breakWaves(toVec3(rest[v]), spacing[v], waves[v]));
        position[v] = toFloat3(axpy(share * inside, way, toVec3(position[v])));
    }

  private:
    /// The mean over the shown parts round the vertex, by area, of what crosses each: whichever way each is
    /// wound, and less where faces meet at an edge.
    DEM_FN Vec3<float> across(uint32_t v, const Vec3<float>& wave) const {
        const Vec3<float> here = toVec3(before[v]);
        Vec3<float> sum;
        float areas = 0;
        for (uint32_t c = corners.start[v]; c < corners.start[v + 1]; ++c) {
            if (face_state[corners.face[c]] == kFaceHidden) continue;
            const Vec3<float> twice =
                cross(toVec3(before[corners.next[c]]) - here, toVec3(before[corners.previous[c]]) - here);
            const float squared = length2(twice);
            if (squared <= 0) continue;
            const float inverse = inverseSqrt(squared);
            sum = axpy(inverse * dot(twice, wave), twice, sum);
            areas += inverse * squared;
        }
        return areas > 0 ? (1.0f / areas) * sum : Vec3<float>{};
    }
};

}  // namespace demolish
