// SPDX-License-Identifier: Apache-2.0
// One Laplacian step on the crack surface: facets of single cells melt into one broken face (geometry.md 4
// d), the more the larger the pieces on both sides are.
#pragma once
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/kernels/steps_that_moved.h"

namespace demolish {

/// Share of the way to the neighbours' mean.
inline constexpr float kRelaxationFactor = 0.6f;

/// Of one vertex; isOver() as steps have it.
struct RelaxPoolVertices {
    PoolCorners corners;
    Span<const uint8_t> face_state;
    Span<const uint32_t> pieces_there;
    Span<const Float3> rest;
    Span<const float> spacing;
    TwoCopies copies;
    StepsThatMoved steps;

    DEM_FN bool isOver(uint32_t step) const { return steps.isOver(step); }
    DEM_FN void operator()(uint32_t v, uint32_t step) const {
        const CrackSmoothing smoothing = faceSmoothing(pieces_there[v]);
        const bool moves = step < smoothing.steps;
        if (moves) steps.note(step);
        const Span<const Float3> before = copies.before(step);
        copies.after(step)[v] = moves ? relaxed(v, smoothing.limit * spacing[v], before) : before[v];
    }

  private:
    DEM_FN Float3 relaxed(uint32_t v, float limit, const Span<const Float3>& before) const {
        Vec3<float> sum;
        float count = 0;
        for (uint32_t c = corners.start[v]; c < corners.start[v + 1]; ++c) {
            const bool shown = face_state[corners.face[c]] != kFaceHidden;
            // Hidden ones are read all the same: without a branch all corners are read at once.
            const Vec3<float> more = toVec3(before[corners.next[c]]) + toVec3(before[corners.previous[c]]);
            sum = shown ? sum + more : sum;
            count += shown ? 2.0f : 0.0f;
        }
        const Vec3<float> here = toVec3(before[v]), from = toVec3(rest[v]);
        const Vec3<float> moved = axpy(kRelaxationFactor, (1.0f / count) * sum - here, here - from);
        const float squared = length2(moved);
        const float scale = squared > limit * limit ? limit * inverseSqrt(squared) : 1.0f;
        return toFloat3(axpy(scale, moved, from));
    }
};

}  // namespace demolish
