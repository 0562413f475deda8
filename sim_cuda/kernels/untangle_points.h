// SPDX-License-Identifier: Apache-2.0
// No part of the outside may turn over when its points slide. Where one would, its points are pushed apart by
// as little as helps; what that does not cure goes part of its way back, and at last all of it.
#pragma once
#include "sim_cuda/kernels/place_points.h"
#include "sim_cuda/kernels/steps_that_moved.h"

namespace demolish {

/// Twice the area of a part seen from outside of where it lay at rest, at the corner of one of its points.
struct PartAt {
    uint32_t next, previous;
    Vec3<float> up;   ///< unit
    float rest, now;  ///< m^2

    /// What it must not fall below.
    DEM_FN float least() const { return rest > 0 ? kLeastShare * rest : rest; }

    static constexpr float kLeastShare = 0.04f;
};

/// OutsideMesh::corner_part. One thread a point, once.
struct MeasureParts {
    /// Of a part's longest side times its distance from the origin: twice an area below that, and its own
    /// normal is mostly the rounding of its points.
    static constexpr float kRounding = 2.5e-7f;

    OutsideMesh mesh;
    Span<Vec4<float>> part;

    DEM_FN void operator()(uint32_t p) const {
        const OutsidePoint& a = mesh.points[p];
        for (uint32_t corner = mesh.corner_start[p]; corner < mesh.corner_start[p + 1]; ++corner) {
            const OutsidePoint &b = mesh.points[mesh.corner_next[corner]],
                               &c = mesh.points[mesh.corner_previous[corner]];
            const Vec3<float> ab = toVec3(b.position) - toVec3(a.position),
                              ac = toVec3(c.position) - toVec3(a.position), rest = cross(ab, ac);
            const float longest = maxOf(maxOf(length2(ab), length2(ac)), length2(ac - ab));
            const float rounding = kRounding * kRounding * longest * length2(toVec3(a.position));
            const Vec3<float> up = normalized(
                length2(rest) > rounding ? rest : toVec3(a.normal) + toVec3(b.normal) + toVec3(c.normal));
            part[corner] = withW(up, dot(rest, up));
        }
    }
};

struct PartsOfOutside {
    OutsideMesh mesh;

    DEM_FN PartAt at(uint32_t p, uint32_t corner, Span<const Float3> position) const {
        const Vec4<float> rest = mesh.corner_part[corner];
        PartAt part{mesh.corner_next[corner], mesh.corner_previous[corner], xyz(rest), rest.w, 0};
        const Vec3<float> here = toVec3(position[p]);
        part.now =
            dot(cross(toVec3(position[part.next]) - here, toVec3(position[part.previous]) - here), part.up);
        return part;
    }
    /// Looks at all parts: without a branch all are read at once.
    DEM_FN bool isTangled(uint32_t p, Span<const Float3> position) const {
        bool any = false;
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1]; ++c) {
            const PartAt part = at(p, c, position);
            any |= part.now < part.least();
        }
        return any;
    }
    DEM_FN bool isTurnedOver(uint32_t p, Span<const Float3> position) const {
        bool any = false;
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1]; ++c) {
            const PartAt part = at(p, c, position);
            any |= part.now < (part.rest > 0 ? 0.0f : part.rest);
        }
        return any;
    }
};

/// Points of parts that are turned over or nearly so.
struct MarkTangled {
    PartsOfOutside parts;
    Span<const Float3> position;
    Span<uint32_t> tangled;  ///< 0 or 1; all 0 before

    DEM_FN void operator()(uint32_t p) const { tangled[p] = parts.isTangled(p, position) ? 1 : 0; }
};

/// And those round them, one ring a call.
struct WidenTangled {
    OutsideMesh mesh;
    Span<const uint32_t> before, moves;
    Span<uint32_t> after;

    DEM_FN void operator()(uint32_t p) const {
        uint32_t any = before[p];
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1] && any == 0; ++c)
            any = before[mesh.corner_next[c]];
        after[p] = any != 0 && moves[p] != 0 ? 1 : 0;
    }
};

/// A step of projection onto "no part below its least area", averaged over the parts at each point.
struct Untangle {
    static constexpr uint32_t kSteps = 24;
    /// Points of cracks give way less than those round them.
    static constexpr float kRimWeight = 0.25f;

    PartsOfOutside parts;
    LayOnOutside lay;
    Span<const RimLink> link;
    Span<const uint32_t> moves;
    TwoCopies copies;
    StepsThatMoved steps;

    DEM_FN bool isOver(uint32_t step) const { return steps.isOver(step); }
    DEM_FN void operator()(uint32_t p, uint32_t step) const {
        const Span<const Float3> before = copies.before(step);
        const Span<Float3> after = copies.after(step);
        const OutsideMesh& mesh = parts.mesh;
        if (!parts.isTangled(p, before)) {
            after[p] = before[p];
            return;
        }
        Vec3<float> sum;
        float count = 0;
        for (uint32_t c = mesh.corner_start[p]; c < mesh.corner_start[p + 1]; ++c) {
            const PartAt part = parts.at(p, c, before);
            const float lack = 1.5f * part.least() - part.now;
            if (part.now >= part.least() || lack <= 0) continue;
            const Vec3<float> here = toVec3(before[p]), next = toVec3(before[part.next]),
                              previous = toVec3(before[part.previous]);
            const Vec3<float> own = cross(part.up, previous - next);
            const float all = weight(p) * length2(own) + weight(part.next) * length2(here - previous) +
                              weight(part.previous) * length2(next - here);
            if (all <= 0) continue;
            sum = axpy(weight(p) * lack / all, own, sum);
            count += 1.0f;
        }
        if (count == 0) {
            after[p] = before[p];
            return;
        }
        steps.note(step);
        // More than one part pulls: their mean, taken a little too far.
        const float share = count > 1.5f ? 1.4f / count : 1.0f;
        const Vec3<float> push =
            atMost(0.1f * mesh.points[p].spacing, alongOutside(mesh.points[p], share * sum));
        after[p] = toFloat3(lay(p, toVec3(before[p]) + push));
    }

  private:
    DEM_FN float weight(uint32_t p) const {
        return moves[p] == 0 ? 0.0f : (link[p].kind == RimKind::kNone ? 1.0f : kRimWeight);
    }
};

/// What is still turned over goes back: by a part of its way, or all of it.
struct TakeBack {
    static constexpr uint32_t kSteps = 24;
    static constexpr uint32_t kPartSteps = 6;  ///< the first ones, in which a part of the way is kept
    static constexpr float kKept = 0.6f;       ///< of the way

    PartsOfOutside parts;
    LayOnOutside lay;
    Span<const Float3> start;
    TwoCopies copies;
    StepsThatMoved steps;

    DEM_FN bool isOver(uint32_t step) const { return steps.isOver(step); }
    DEM_FN void operator()(uint32_t p, uint32_t step) const {
        const Span<const Float3> before = copies.before(step);
        const float kept = step < kPartSteps ? kKept : 0.0f;
        const Vec3<float> from = toVec3(start[p]);
        Float3 to = before[p];
        if (parts.isTurnedOver(p, before)) {
            steps.note(step);
            to = kept > 0 ? toFloat3(lay(p, axpy(kept, toVec3(to) - from, from))) : start[p];
        }
        copies.after(step)[p] = to;
    }
};

}  // namespace demolish
