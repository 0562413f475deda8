// SPDX-License-Identifier: Apache-2.0
// The few particles that are much faster than all others: a crumb that flies off would shorten everybody's
// horizon. They are kept out of the grid and compared with every particle instead (find_neighbours.h).
//
//   samples in bins along each axis -> bins in which nearly all lie -> how many are outside
//
// Samples only suggest the bins; who is outside is decided by the bins alone, so that every device agrees.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/velocity_range.h"

namespace demolish {

/// Bins along an axis of the box of all velocities; every so many-th particle is a sample.
inline constexpr uint32_t kVelocityBins = 32, kSampleEvery = 16;
/// Of the samples, one in so many may lie outside at each of the six sides, and no more than kMostOutside.
inline constexpr uint32_t kOutsideShare = 120, kMostOutside = 5;
/// With more outside than this nobody is set apart.
inline constexpr uint32_t kMostFast = 1024;

template <class Real>
DEM_FN uint32_t velocityBin(Real v, Real low, Real high) {
    if (!(high > low)) return 0;
    const Real scaled = (v - low) / (high - low) * Real(kVelocityBins);
    return scaled < Real(kVelocityBins - 1) ? static_cast<uint32_t>(maxOf(scaled, Real(0)))
                                            : kVelocityBins - 1;
}

/// Bins of the slow, first and last, along each axis.
struct SlowBins {
    uint32_t first[3] = {}, last[3] = {kVelocityBins - 1, kVelocityBins - 1, kVelocityBins - 1};
};

template <class Real>
struct AxisOf {
    Real v, low, high;
};
template <class Real>
DEM_FN AxisOf<Real> alongAxis(uint32_t axis, const Vec3<Real>& v, const VelocityRange<Real>& box) {
    return axis == 0   ? AxisOf<Real>{v.x, box.low.x, box.high.x}
           : axis == 1 ? AxisOf<Real>{v.y, box.low.y, box.high.y}
                       : AxisOf<Real>{v.z, box.low.z, box.high.z};
}

template <class Real>
DEM_FN bool isOutside(const Vec3<Real>& v, const VelocityRange<Real>& box, const SlowBins& slow) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const AxisOf<Real> along = alongAxis(axis, v, box);
        const uint32_t bin = velocityBin(along.v, along.low, along.high);
        if (bin < slow.first[axis] || bin > slow.last[axis]) return true;
    }
    return false;
}

/// One thread a sample.
template <class Real>
struct SampleVelocities {
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const VelocityRanges<Real>> ranges;  ///< one
    Span<uint32_t> bins;                      ///< kVelocityBins an axis, 0 before

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t i = k * kSampleEvery;
        if (!(constants[i].takesPart())) return;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const AxisOf<Real> along = alongAxis(axis, xyz(state.velocity[i]), ranges[0].bodies);
            atomicAddU32(&bins[axis * kVelocityBins + velocityBin(along.v, along.low, along.high)], 1);
        }
    }
};

/// One thread an axis.
struct TrimVelocities {
    Span<const uint32_t> bins;
    Span<SlowBins> slow;  ///< one
    uint32_t samples = 0;

    DEM_FN void operator()(uint32_t axis) const {
        uint32_t count[kVelocityBins];
        for (uint32_t bin = 0; bin < kVelocityBins; ++bin) count[bin] = bins[axis * kVelocityBins + bin];
        const uint32_t share = samples / kOutsideShare, allowed = share < kMostOutside ? share : kMostOutside;
        uint32_t first = 0, last = kVelocityBins - 1;
        for (uint32_t seen = count[0]; seen <= allowed && first < last; seen += count[first]) ++first;
        for (uint32_t seen = count[last]; seen <= allowed && last > first; seen += count[last]) --last;
        slow[0].first[axis] = first;
        slow[0].last[axis] = last;
    }
};

/// One thread a particle of a body.
template <class Real>
struct CountFast {
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const VelocityRanges<Real>> ranges;  ///< one
    Span<const SlowBins> slow;                ///< one
    Span<const uint32_t> place_kind;          ///< 0: looked for in the grid (fill_grid.h)
    Span<uint32_t> count;                     ///< one, 0 before

    DEM_FN void operator()(uint32_t i) const {
        if (!(constants[i].takesPart()) || place_kind[i] != 0) return;
        if (isOutside(xyz(state.velocity[i]), ranges[0].bodies, slow[0])) atomicAddU32(&count[0], 1);
    }
};

/// The box of the slow bins, no narrower than they are.
template <class Real>
DEM_FN VelocityRange<Real> slowRange(const VelocityRange<Real>& box, const SlowBins& slow) {
    constexpr Real kShare = Real(1) / Real(kVelocityBins);
    const auto edge = [&](Real low, Real high, uint32_t bin) {
        return madd(kShare * static_cast<Real>(bin), high - low, low);
    };
    VelocityRange<Real> range;
    range.low = {edge(box.low.x, box.high.x, slow.first[0]), edge(box.low.y, box.high.y, slow.first[1]),
                 edge(box.low.z, box.high.z, slow.first[2])};
    range.high = {edge(box.low.x, box.high.x, slow.last[0] + 1),
                  edge(box.low.y, box.high.y, slow.last[1] + 1),
                  edge(box.low.z, box.high.z, slow.last[2] + 1)};
    return range;
}

}  // namespace demolish
