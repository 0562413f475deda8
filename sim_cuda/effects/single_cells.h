// SPDX-License-Identifier: Apache-2.0
// Single cells crumble: what is left of one is drawn smaller, by the law of sizes, and what it has lost flies
// as crumbs. Cells are all of one size; debris is not.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/effects/sources.h"
#include "sim_cuda/kernels/fragment_sums.h"

namespace demolish {

/// Of a body of several cells, the only one of its fragment.
DEM_FN bool isSingle(const FragmentRows& rows, uint32_t i, const DebrisLaw& law) {
    return rows.fragment[i] == i && rows.size[i] == 1 && law.cells > 1;
}

/// Share of its size that is left of cell i, kLeastRest to 1.
DEM_FN float restOf(const SizeTables& sizes, uint64_t seed, uint32_t i) {
    Draws draws(seed ^ 0x2545f491u, i);
    return sizeAt(sizes.rest, draws.uniform());
}

inline constexpr uint32_t kMostCrumbs = 24;
/// Of a grain with a size of 1 across.
inline constexpr float kGrainVolume = 0.07f;

/// Calls visit(size in spacings) for each crumb, until they are as large as what is gone.
template <class Visit>
DEM_FN void forEachCrumb(const SizeTables& sizes, uint64_t seed, uint32_t i, const Visit& visit) {
    const float rest = restOf(sizes, seed, i), lost = 0.8f * (1.0f - rest * rest * rest);
    Draws draws(seed ^ 0x7f4a7c15u, i);
    float used = 0;
    for (uint32_t k = 0; k < kMostCrumbs && used < lost; ++k) {
        const float size = sizeAt(sizes.crumbs, draws.uniform());
        used += kGrainVolume * size * size * size;
        visit(size);
    }
}

template <class Real>
struct CountOfCells {
    BodiesNow<Real> bodies;
    FragmentRows rows;
    Span<uint8_t> crumbled;        ///< per particle
    Span<uint32_t> grains, puffs;  ///< per particle
    uint64_t seed = 0;

    DEM_FN void operator()(uint32_t i) const {
        grains[i] = puffs[i] = 0;
        if (crumbled[i] != 0 || !isSingle(rows, i, bodies.lawOf(i))) return;
        crumbled[i] = 1;
        uint32_t count = 0;
        forEachCrumb(bodies.sizes, seed, i, [&](float) { ++count; });
        grains[i] = count;
    }
};

template <class Real>
struct ThrowOffCells {
    BodiesNow<Real> bodies;
    Births births;

    DEM_FN void operator()(uint32_t i) const {
        if (births.grainsOf(i) == 0) return;
        const DebrisLaw& law = bodies.lawOf(i);
        Source source{bodies.position(i), bodies.velocity(i)};
        source.violence = 0.2f + 0.1f * length(source.velocity);
        uint32_t k = 0;
        forEachCrumb(bodies.sizes, births.seed, i, [&](float size) {
            const uint32_t number = births.grainNumber(i, k++);
            Draws draws = births.grainDraws(number);
            Source from = source;
            from.position = axpy(0.45f * law.spacing, draws.inBall(), source.position);
            Grain crumb = thrown(from, law.spacing * size, law.drag, births.elapsed, draws);
            crumb.spin = 0.25f * crumb.spin;
            births.put(number, crumb);
        });
    }
};

/// Cells that are single already have crumbled before.
struct MarkSingleCells {
    FragmentRows rows;
    Span<const uint32_t> owner;
    Span<const DebrisLaw> law;
    Span<uint8_t> crumbled;

    DEM_FN void operator()(uint32_t i) const { crumbled[i] = isSingle(rows, i, law[owner[i]]) ? 1 : 0; }
};

/// A cell as it is drawn, m in its body's frame.
struct DrawnCell {
    Vec3<float> centre;
    float radius = 0;  ///< of the ball of its volume
};

inline std::vector<DrawnCell> drawnCells(const std::vector<BodyInstance>& bodies) {
    std::vector<DrawnCell> cells;
    for (const BodyInstance& instance : bodies)
        for (const Particle& p : instance.body->particles)
            cells.push_back({{float(p.centroid.x), float(p.centroid.y), float(p.centroid.z)},
                             float(std::cbrt(3 * p.volume / (4 * kPi)))});
    return cells;
}

/// What is left of a single cell keeps its centre, or goes down to what it lies on, whose touched point
/// stays.
struct ShrinkSingleCells {
    FragmentRows rows;
    Span<const uint32_t> owner;
    Span<const DebrisLaw> law;
    Span<const DrawnCell> cell;
    SizeTables sizes;
    ColliderSet<float> colliders;
    uint64_t seed = 0;
    Span<FragmentTransform> transform;

    DEM_FN void operator()(uint32_t i) const {
        if (!isSingle(rows, i, law[owner[i]])) return;
        FragmentTransform own = transform[i];
        own.shrink = static_cast<uint32_t>((1.0f - restOf(sizes, seed, i)) / kShrinkStep) & 0xffu;
        const float lost = kShrinkStep * static_cast<float>(own.shrink), radius = cell[i].radius;
        const Quat<float> turn{own.rotation.x, own.rotation.y, own.rotation.z, own.rotation.w};
        const Vec3<float> arm = rotate(turn, cell[i].centre), before = toVec(own.translation);
        Vec3<float> moved = lost * arm;
        for (uint32_t c = 0; c < colliders.count; ++c) {
            const TangentPlane<float> tangent = colliders.tangent(c, before + arm);
            const float near = clampTo(2.5f - tangent.distance / radius, 0.0f, 1.0f);
            moved = axpy(-lost * maxOf(tangent.distance, 0.0f) * near, xyz(tangent.plane), moved);
        }
        own.translation = {before.x + moved.x, before.y + moved.y, before.z + moved.z};
        transform[i] = own;
    }

  private:
    DEM_FN static Vec3<float> toVec(const Float3& p) { return {p.x, p.y, p.z}; }
};

}  // namespace demolish
