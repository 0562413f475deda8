// SPDX-License-Identifier: Apache-2.0
// A line of cracks on the outside loses the teeth of its cells: each point goes to the weighted mean of the
// line round it. By length along the line, because its edges are of very uneven lengths.
#pragma once
#include "sim_cuda/kernels/rim_walk.h"

namespace demolish {

/// One thread a point on the border of cells.
struct SlideRims {
    /// Over this many sigmas a line takes over how far the junction at its end has moved.
    static constexpr float kEndFade = 1.5f;

    OutsideMesh mesh;
    RimLines lines;
    Span<const uint32_t> border;
    Span<Float3> place;  ///< written where a line goes through

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t p = border[i];
        if (!lines.goesOn(p)) return;
        const OutsidePoint& point = mesh.points[p];
        const Vec3<float> rest = toVec3(point.position);
        const float sigma = crackSmoothing(lines.link[p].smallest).line * point.spacing;
        place[p] = point.position;
        if (sigma <= 0) return;
        Mean mean{rest, {}, {}, 0};
        walk(p, lines.link[p].next[0], sigma, mean);
        walk(p, lines.link[p].next[1], sigma, mean);
        if (mean.weight <= 0) return;
        const Vec3<float> shift = alongOutside(point, axpy(1.0f / mean.weight, mean.sum, mean.ends));
        place[p] = toFloat3(rest + atMost(point.reach, shift));
    }

  private:
    struct Mean {
        Vec3<float> from, sum, ends;
        float weight;
    };
    /// One way along the line. At its end it goes on as what has been passed, turned round that end.
    DEM_FN void walk(uint32_t p, uint32_t first, float sigma, Mean& mean) const {
        const float reach = kLineReach * sigma;
        uint32_t before = p, now = first;
        Vec3<float> from = lines.at(p), pivot;
        bool turned = false;
        float way = 0;
        for (uint32_t step = 0; step < kMostRimSteps && way < reach; ++step) {
            const Vec3<float> real = lines.at(now), to = turned ? 2.0f * pivot - real : real;
            const float part = length(to - from), weight = bump((way + 0.5f * part) / reach) * part;
            mean.sum = axpy(weight, 0.5f * (from + to) - mean.from, mean.sum);
            mean.weight += weight;
            way += part;
            from = to;
            const uint32_t last = before;
            before = now;
            if (lines.goesOn(now)) {
                now = lines.beyond(last, now);
            } else {
                if (turned) return;
                turned = true;
                pivot = real;
                mean.ends =
                    axpy(1.0f - smoothStep(way / (kEndFade * sigma)), lines.shiftOfEnd(now), mean.ends);
                now = last;
            }
        }
    }
};

}  // namespace demolish
