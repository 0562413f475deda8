// SPDX-License-Identifier: Apache-2.0
// Sums over the particles of each fragment in an order that is the same on every device: particles sorted by
// (fragment, id), terms folded eight at a time along that order, in double.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/physics/rigid_fit.h"

namespace demolish {

inline constexpr uint32_t kFoldWidth = 8;

/// Particles in order of (fragment, id): fragment f stands at first[f] .. first[f] + size[f] - 1.
struct FragmentRows {
    Span<const uint32_t> order;     ///< ids
    Span<const uint32_t> fragment;  ///< of each particle: the lowest id in it
    Span<const uint32_t> first;     ///< per fragment slot
    Span<const uint32_t> size;      ///< per slot; 0 for one that names no fragment
};

/// One thread a place in the order.
struct MarkFragments {
    Span<const uint32_t> order, fragment;
    Span<uint32_t> first;

    DEM_FN void operator()(uint32_t at) const {
        const uint32_t own = fragment[order[at]];
        if (at == 0 || fragment[order[at - 1]] != own) first[own] = at;
    }
};
struct MeasureFragments {
    Span<const uint32_t> order, fragment, first;
    Span<uint32_t> size;  ///< 0 before

    DEM_FN void operator()(uint32_t at) const {
        const uint32_t own = fragment[order[at]];
        if (at + 1 == order.size() || fragment[order[at + 1]] != own) size[own] = at + 1 - first[own];
    }
};

/// terms[place] += terms of the next kFoldWidth - 1 multiples of `stride`; after strides 1, 8, 64 ... the
/// place `first` of each fragment holds the sum.
template <class Terms>
struct FoldFragments {
    FragmentRows rows;
    Span<Terms> terms;
    uint32_t stride = 1;

    DEM_FN void operator()(uint32_t at) const {
        const uint32_t own = rows.fragment[rows.order[at]], rank = at - rows.first[own];
        if (rank % (kFoldWidth * stride) != 0) return;
        Terms sum = terms[at];
        for (uint32_t k = 1; k < kFoldWidth && rank + k * stride < rows.size[own]; ++k)
            sum = sum + terms[at + k * stride];
        terms[at] = sum;
    }
};

/// What the drawn motion needs: masses where they are and where they were at rest, and how they have turned.
struct PoseSums {
    MassSums now;
    Vec3<double> rest_moment;         ///< sum m x_rest, kg m, body frame
    Quat<double> turned{0, 0, 0, 0};  ///< sum m q, kg
};
DEM_FN PoseSums operator+(const PoseSums& a, const PoseSums& b) {
    return {
        a.now + b.now,
        a.rest_moment + b.rest_moment,
        {a.turned.x + b.turned.x, a.turned.y + b.turned.y, a.turned.z + b.turned.z, a.turned.w + b.turned.w}};
}

template <class Real>
DEM_FN Vec3<double> asDouble(const Vec3<Real>& a) {
    return {double(a.x), double(a.y), double(a.z)};
}
/// High and low part, added in double.
template <class Real>
DEM_FN Vec3<double> exactPosition(const StateIn<Real>& state, uint32_t i) {
    return asDouble(xyz(state.position[i])) +
           asDouble(lowPart(state.position[i], state.velocity[i], state.spin[i]));
}

template <class Real>
struct StartPoseSums {
    FragmentRows rows;
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const Vec4<Real>> rest_position;  ///< m, body frame
    Span<PoseSums> terms;

    DEM_FN void operator()(uint32_t at) const {
        const uint32_t i = rows.order[at];
        const Quat<Real> q = asQuat(state.rotation[i]), reference = asQuat(state.rotation[rows.fragment[i]]);
        const Real aligned = dot(vectorPart(q), vectorPart(reference)) + q.w * reference.w;
        const double mass = 1.0 / double(constants[i].inverseMass()),
                     weight = aligned < Real(0) ? -mass : mass;
        terms[at] = {
            massOf(mass, exactPosition(state, i), asDouble(xyz(state.velocity[i]))),
            mass * asDouble(xyz(rest_position[i])),
            {weight * double(q.x), weight * double(q.y), weight * double(q.z), weight * double(q.w)}};
    }
};

template <class Real>
struct StartSpinSums {
    FragmentRows rows;
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const PoseSums> pose;  ///< folded
    Span<SpinSums> terms;

    DEM_FN void operator()(uint32_t at) const {
        const uint32_t i = rows.order[at];
        const MassSums& whole = pose[rows.first[rows.fragment[i]]].now;
        terms[at] =
            spinOf(1.0 / double(constants[i].inverseMass()), 1.0 / double(constants[i].inverse_inertia),
                   exactPosition(state, i) - massCentre(whole),
                   asDouble(xyz(state.velocity[i])) - meanVelocity(whole), asDouble(xyz(state.spin[i])));
    }
};

}  // namespace demolish
