// SPDX-License-Identifier: Apache-2.0
// Before the first frame the bodies settle (models E.4): gravity comes on slowly, velocities decay, nothing
// breaks; then they get the velocities of the set-up.
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/solver/frame_loop.h"

namespace demolish {

/// Gravity is switched on over this share of the settling time (models E.4).
inline constexpr double kSettleRampShare = 0.3;

/// Zero, or those of the set-up; the low parts of the positions stay. Waits.
template <class Backend, class Real>
void setVelocities(DeviceScene<Backend, Real>& scene, bool at_rest) {
    const StateOut<Real> now = scene.data.particles.out(scene.data.current);
    const SceneTables& tables = scene.tables;
    auto velocity = scene.backend.downloaded(now.velocity), spin = scene.backend.downloaded(now.spin);
    for (uint32_t i = 0; i < tables.counts.in_bodies; ++i) {
        velocity[i] = withLowOf(at_rest ? Vec3<Real>{} : toReal<Real>(tables.velocity[i]), velocity[i]);
        spin[i] = withLowOf(at_rest ? Vec3<Real>{} : toReal<Real>(tables.spin[i]), spin[i]);
    }
    scene.backend.upload(now.velocity, velocity.data(), velocity.size());
    scene.backend.upload(now.spin, spin.data(), spin.size());
    scene.backend.synchronize();
}

/// As SolverParams say; the run starts anew after it. Throws NumericalError when the bodies blow up,
/// Cancelled when the callback says so.
template <class Backend, class Real>
void settle(DeviceScene<Backend, Real>& scene, FrameLoop<Backend, Real>& loop,
            const ProgressCallback& progress) {
    const SolverParams& asked = scene.setup.params;
    const StepParams<Real> free_params = scene.params;
    const auto substeps = static_cast<uint64_t>(std::ceil(asked.settle_time / scene.tables.time_step));
    scene.params.breaking = 0;
    scene.params.velocity_keep = static_cast<Real>(1 - asked.settle_damping * scene.tables.time_step);
    setVelocities(scene, true);
    while (scene.substeps < substeps) {
        const double share = static_cast<double>(scene.substeps) / static_cast<double>(substeps);
        scene.params.gravity =
            static_cast<Real>(std::min(1.0, share / kSettleRampShare)) * free_params.gravity;
        for (int stretch = 0; stretch < 5; ++stretch) {
            if (progress && !progress(share, "Settling")) throw Cancelled();
            if (loop.runStretch(kBondedStretch) != StepStatus::kOk)
                throw NumericalError(
                    "The bodies blew up while settling: see that none stands in another, or raise "
                    "--substeps.");
        }
    }
    scene.params = free_params;
    setVelocities(scene, false);
    scene.backend.fill(scene.data.ledger.span(), Vec4<Real>{});
    loop.resume(LoopState{});
}

}  // namespace demolish
