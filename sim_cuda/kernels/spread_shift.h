// SPDX-License-Identifier: Apache-2.0
// What lies round a crack follows it: its shift is filled in smoothly between points of cracks, whose shifts
// are given, and what stays.
#pragma once
#include "sim_cuda/data/outside_mesh.h"
#include "sim_cuda/kernels/steps_that_moved.h"

namespace demolish {

/// Weights by nearness of the points that follow round the parts at a point. One thread a point, once.
struct WeighCorners {
    OutsideMesh mesh;
    Span<float> weight;

    DEM_FN void operator()(uint32_t p) const {
        const Vec3<float> here = toVec3(mesh.points[p].position);
        // Points that all but coincide must not outweigh all others.
        const float least = 1e-3f * mesh.points[p].spacing;
        float sum = 0;
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1]; ++c) {
            const Vec3<float> to = toVec3(mesh.points[mesh.corner_next[c]].position) - here;
            weight[c] = 1.0f / (length(to) + least);
            sum += weight[c];
        }
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1]; ++c) weight[c] /= sum;
    }
};

/// One step of a second-order Jacobi iteration: it carries the shift as many edges far as there are steps.
struct SpreadShift {
    /// The best for a spectral radius of 0.98, about that of a cell's outside with ten points across.
    static constexpr float kMomentum = 1.65f;
    static constexpr uint32_t kSteps = 24;

    OutsideMesh mesh;
    Span<const RimLink> link;
    TwoCopies copies;  ///< of the shift: the one written holds what was before, and becomes what comes next

    DEM_FN bool isOver(uint32_t) const { return false; }
    DEM_FN void operator()(uint32_t p, uint32_t step) const {
        const Span<const Float3> now = copies.before(step);
        const Span<Float3> before = copies.after(step);
        if (link[p].kind != RimKind::kNone) return;
        Vec3<float> mean;
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1]; ++c)
            mean = axpy(mesh.corner_weight[c], toVec3(now[mesh.corner_next[c]]), mean);
        const Vec3<float> old = toVec3(before[p]);
        before[p] = toFloat3(alongOutside(mesh.points[p], axpy(kMomentum, mean - old, old)));
    }
};

}  // namespace demolish
