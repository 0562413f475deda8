// SPDX-License-Identifier: Apache-2.0
// How fast a wave runs along a bar, measured with the solver's own substep: from the bar's first longitudinal
// mode.
#pragma once
#include "sim_cuda/solver/scene_tables.h"

namespace demolish::tests {

struct BarWave {
    double speed = 0;          ///< m/s, c = 2 L f
    double critical_step = 0;  ///< s, dt_crit = 2 / omega_max
};

/// Rings the bar of `tables` (one free body, undamped, unbreakable) in its first mode along `axis` (unit)
/// through its middle, on the device under test; `length` in m. The step is half the critical one.
BarWave ringBar(const SceneSetup& setup, const SceneTables& tables, const Vec3<double>& axis, double length);
BarWave ringBarOnGpu(const SceneSetup& setup, const SceneTables& tables, const Vec3<double>& axis,
                     double length);

}  // namespace demolish::tests
