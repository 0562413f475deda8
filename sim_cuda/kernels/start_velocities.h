// SPDX-License-Identifier: Apache-2.0
// FragmentVelocities, when a frame starts and where a rigid body or a sleeper wakes.
#pragma once
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/fragment_sums.h"
#include "sim_cuda/kernels/lead_held.h"

namespace demolish {

/// What has been decided. Without: everything is moved with its bonds, and a frame starts.
struct DecidedRegimes {
    Span<const uint32_t> regime, former;  ///< per slot
    Span<const RigidBody> body;           ///< per slot
    bool frame_starts = true;

    DEM_FN bool isBonded(uint32_t slot) const {
        return regime.data == nullptr || regime[slot] == wordOf(Regime::kBonded);
    }
    DEM_FN bool wasBonded(uint32_t slot) const { return former[slot] == wordOf(Regime::kBonded); }
    /// m/s, of a body that wakes within a frame.
    DEM_FN Vec3<double> velocityOfWaking(uint32_t slot) const {
        return former[slot] == wordOf(Regime::kRigid) ? body[slot].velocity : Vec3<double>{};
    }
};

/// One thread a slot: of what is moved with its bonds from now on. Within a frame the others go on.
template <class Real>
struct StartVelocities {
    FragmentRows rows;
    Span<const uint32_t> label;
    Span<const PoseSums> pose;  ///< by place, of the frame's start
    HoldsIn holds;
    Vec3<double> fall;  ///< m/s, that gravity adds in half a frame
    Span<Vec4<Real>> start;
    Span<uint64_t> added[2];
    DecidedRegimes moved;

    DEM_FN void operator()(uint32_t slot) const {
        if (slot >= rows.order.size() || label[slot] != slot || !moved.isBonded(slot)) return;
        if (!moved.frame_starts && moved.wasBonded(slot)) return;
        const MassSums& sums = pose[rows.first[slot]].now;
        const Vec3<double> v = moved.frame_starts ? meanVelocity(sums) + fall : moved.velocityOfWaking(slot);
        start[slot] = {Real(v.x), Real(v.y), Real(v.z), Real(holds.hold(slot) ? 0 : 1 / sums.mass)};
        for (const Span<uint64_t>& both : added)
            for (uint32_t axis = 0; axis < 3; ++axis) both[3 * size_t{slot} + axis] = 0;
    }
};

}  // namespace demolish
