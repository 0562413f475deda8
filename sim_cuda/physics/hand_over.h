// When a fragment's bonds may rest and when they must work: the bounds of architecture 9, each a speed
// measured in the speed that breaks the material. A particle that swings at beta v_c carries the stress
// sigma_c = rho c (beta v_c) of models E.2.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// Inner vibration has died when the mean square of the particles' speeds against their fragment's rigid
/// motion is below the square of this share of beta v_c for kCalmSeconds, a frame: 1.5 % of the energy at
/// which the material breaks.
inline constexpr double kCalmShare = 0.12, kCalmSeconds = 0.016;

/// Pieces of so many particles or fewer, or of this share of their body, are crumbs: whatever swings in them
/// may stop, and once they are rigid they stay whole.
inline constexpr uint32_t kCrumbParticles = 8;
inline constexpr double kCrumbShare = 0.0025;

/// Particles of the largest crumb of bodies of `particles` each.
inline uint32_t crumbParticles(double particles) {
    const auto share = static_cast<uint32_t>(kCrumbShare * particles);
    return share > kCrumbParticles ? share : kCrumbParticles;
}

/// A meeting at a share of the body's threshold velocity or more brings the bonds back before the two touch.
/// The threshold is that of a whole body; what has cracked already, or comes down turning, breaks from less
/// of it on, and that of a slender body from half of it: of the bonds that a shot wolf loses a fifth were in
/// pieces that would have stayed rigid at 0.7, a seventh at 0.5, three in a hundred at 0.35, while a rabbit
/// loses as many at 0.7 as at 0.35. Hence kWakeShare over the square of the body's spread
/// (solver/wake_share.h), between these two.
inline constexpr double kWakeShare = 0.95, kLeastWakeShare = 0.35, kMostWakeShare = 0.7;

/// Above all of these speeds (m/s) a meeting is hard: `heavy` however heavy the two are; `light` over the
/// root of the reduced number of particles, since a crumb of one particle loads the bonds where it hits by v
/// / (beta v_c) of their strength at most.
template <class Real>
struct WakeLaw {
    Real heavy{}, light{};
};

/// At rest: no particle faster than kRestSpeed (m/s) for kRestSeconds (models E.4).
inline constexpr double kRestSpeed = 0.02, kRestSeconds = 0.25;

/// m/s.
inline double calmSpeed(double beta, double critical_velocity) {
    return kCalmShare * beta * critical_velocity;
}
inline WakeLaw<double> wakeLaw(double beta, double critical_velocity, double threshold_share,
                               double wake_share) {
    return {wake_share * threshold_share * critical_velocity, beta * critical_velocity};
}

/// m/s, between pieces of n_i and n_j particles.
template <class Real>
DEM_FN Real wakeSpeed(const WakeLaw<Real>& a, const WakeLaw<Real>& b, Real n_i, Real n_j) {
    const Real light = minOf(a.light, b.light) * inverseSqrt(n_i * n_j / (n_i + n_j));
    return maxOf(minOf(a.heavy, b.heavy), light);
}

}  // namespace demolish
