// SPDX-License-Identifier: Apache-2.0
// What becomes of the sums over a fragment: the transform it is drawn with, its rigid motion by (16)-(18),
// its age.
#pragma once
#include "sim_cuda/kernels/fragment_sums.h"

namespace demolish {

/// One thread a slot; slots that name no fragment are left alone. Rotation = mean quaternion by mass; it
/// takes the centre of mass at rest to where it is now.
struct WriteTransforms {
    FragmentRows rows;
    Span<const PoseSums> pose;
    Span<const uint32_t> age;
    Span<FragmentTransform> transform;

    DEM_FN void operator()(uint32_t slot) const {
        if (rows.fragment[slot] != slot) return;
        const PoseSums sums = pose[rows.first[slot]];
        const Quat<double> q = normalized(sums.turned);
        const Vec3<double> rest_centre = (1.0 / sums.now.mass) * sums.rest_moment;
        const Vec3<double> shift = massCentre(sums.now) - rotate(q, rest_centre);
        FragmentTransform out;
        out.rotation = {float(q.x), float(q.y), float(q.z), float(q.w)};
        out.translation = {float(shift.x), float(shift.y), float(shift.z)};
        out.age = age[slot] & 0xffffffu;
        transform[slot] = out;
    }
};

struct WriteMotions {
    FragmentRows rows;
    Span<const PoseSums> pose;
    Span<const SpinSums> spin;
    Span<RigidMotion> motion;

    DEM_FN void operator()(uint32_t slot) const {
        if (rows.fragment[slot] != slot) return;
        motion[slot] = rigidMotion(pose[rows.first[slot]].now, spin[rows.first[slot]]);
    }
};

/// Frames since a fragment came into being; 0 while it is its whole body. Fragments only ever lose particles:
/// one of the same lowest particle and the same size is the same fragment.
struct AdvanceAges {
    FragmentRows rows;
    Span<const uint32_t> owner;           ///< body of each particle
    Span<const uint32_t> body_particles;  ///< per body
    Span<uint32_t> former_size, age;      ///< per slot

    DEM_FN void operator()(uint32_t slot) const {
        const uint32_t size = rows.fragment[slot] == slot ? rows.size[slot] : 0;
        const bool whole = size == body_particles[owner[slot]];
        age[slot] = whole || size == 0 ? 0 : (size == former_size[slot] ? age[slot] + 1 : 1);
        former_size[slot] = size;
    }
};

/// How many fragments, and the mass (kg) of the largest; folded by FoldSummaries.
struct FragmentSummary {
    uint32_t fragments = 0;
    double largest_mass = 0;
};
struct SummaryOf {
    FragmentRows rows;
    Span<const PoseSums> pose;

    DEM_FN FragmentSummary operator()(uint32_t slot) const {
        if (rows.fragment[slot] != slot) return {};
        return {1, pose[rows.first[slot]].now.mass};
    }
};
struct FoldSummaries {
    DEM_FN void operator()(FragmentSummary& into, const FragmentSummary& other) const {
        into.fragments += other.fragments;
        into.largest_mass = maxOf(into.largest_mass, other.largest_mass);
    }
};

}  // namespace demolish
