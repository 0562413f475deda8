// When a fragment's bonds may rest and when they must work: the bounds of architecture 9, each a speed
// measured in the speed that breaks the material. A particle that swings at beta v_c carries the stress
// sigma_c = rho c (beta v_c) of models E.2.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// Inner vibration has died when no particle moves against its fragment's rigid motion faster than this share
/// of beta v_c, for kCalmSeconds: its energy is below 2 % of what breaks it, and it is no turning point of a
/// slow swing.
inline constexpr double kCalmShare = 0.15, kCalmSeconds = 0.03;

/// A meeting at this share of v_c or more brings the bonds back before the two touch. The lowest threshold of
/// the four models is 0.21 v_c (thin-walled vase, models E.2).
inline constexpr double kWakeShare = 0.15;

/// At rest: no particle faster than kRestSpeed (m/s) for kRestSeconds (models E.4).
inline constexpr double kRestSpeed = 0.02, kRestSeconds = 0.25;

/// m/s.
inline double calmSpeed(double beta, double critical_velocity) {
    return kCalmShare * beta * critical_velocity;
}
inline double wakeSpeed(double critical_velocity) {
    return kWakeShare * critical_velocity;
}

}  // namespace demolish
