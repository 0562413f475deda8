// SPDX-License-Identifier: Apache-2.0
// Stable step of the leapfrog (physics B.3): undamped limit and damped limit.
#pragma once
#include <cmath>

namespace demolish {

/// dt_crit = 2/omega_max, s, undamped; omega in rad/s.
inline double criticalStep(double omega_max) {
    return 2 / omega_max;
}

/// Largest share of dt_crit with lagged damping: sqrt(1+zeta_m^2) - zeta_m; zeta_m = damping ratio of the
/// highest mode.
inline double dampedStepShare(double zeta_m) {
    return std::sqrt(1 + zeta_m * zeta_m) - zeta_m;
}

/// (E3) beta_R = 2 zeta_m/omega_max, s.
inline double stiffnessDamping(double zeta_m, double omega_max) {
    return 2 * zeta_m / omega_max;
}

/// dt = safety * 2/omega_max, s, never above the damped limit. Safety in (0, 1), 0.5 by default (physics
/// B.3).
inline double stableStep(double omega_max, double zeta_m, double safety = 0.5) {
    return std::fmin(safety, dampedStepShare(zeta_m)) * criticalStep(omega_max);
}

}  // namespace demolish
