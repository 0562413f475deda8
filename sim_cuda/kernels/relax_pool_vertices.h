// SPDX-License-Identifier: Apache-2.0
// One Laplacian step on the crack surface: facets of single cells melt into one broken face (geometry.md 4
// d).
#pragma once
#include "sim_cuda/data/fracture_mesh.h"

namespace demolish {

/// Share of the way to the neighbours' mean, and how far from rest a vertex may go, over h.
inline constexpr float kRelaxationFactor = 0.6f, kRelaxationLimit = 0.35f;

struct RelaxPoolVertices {
    PoolCorners corners;
    Span<const uint8_t> face_state;
    Span<const uint8_t> movable;
    Span<const Float3> rest, before;
    Span<const float> spacing;
    Span<Float3> after;

    DEM_FN void operator()(uint32_t v) const { after[v] = movable[v] != 0 ? relaxed(v) : before[v]; }

    DEM_FN Float3 relaxed(uint32_t v) const {
        Vec3<float> sum;
        float count = 0;
        for (uint32_t c = corners.start[v]; c < corners.start[v + 1]; ++c) {
            if (face_state[corners.face[c]] == kFaceHidden) continue;
            sum = sum + (toVec3(before[corners.next[c]]) + toVec3(before[corners.previous[c]]));
            count += 2.0f;
        }
        const Vec3<float> here = toVec3(before[v]), from = toVec3(rest[v]);
        const Vec3<float> moved = axpy(kRelaxationFactor, (1.0f / count) * sum - here, here - from);
        const float limit = kRelaxationLimit * spacing[v], squared = length2(moved);
        const float scale = squared > limit * limit ? limit * inverseSqrt(squared) : 1.0f;
        return toFloat3(axpy(scale, moved, from));
    }
};

}  // namespace demolish
