// SPDX-License-Identifier: Apache-2.0
// When a fragment's bonds may rest and when they must work: the bounds of architecture 9, each a speed
// measured in the speed that breaks the material. A particle that swings at beta v_c carries the stress
// sigma_c = rho c (beta v_c) of models E.2.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// Inner vibration has died when the mean square of the particles' speeds against their fragment's rigid
/// motion is below the square of this share of beta v_c for kCalmSeconds, a frame: 1.5 % of the energy at
/// which the material breaks. At 0.25 vases broke a tenth fewer bonds than with bonds alone.
inline constexpr double kCalmShare = 0.12, kCalmSeconds = 0.016;

/// s, the longest substep with which fragments go on as rigid bodies: what falls for a metre moves by two
/// centimetres in a contact step of ten of these. Longer ones are of scenes that cost little anyway.
inline constexpr double kLongestHandOverStep = 5e-4;

/// Pieces of so many particles or fewer, or of this share of their body, are crumbs: whatever swings in them
/// may stop, and once they are rigid they stay whole.
inline constexpr uint32_t kCrumbParticles = 8;
inline constexpr double kCrumbShare = 0.0025;

/// Particles of the largest crumb of bodies of `particles` each.
inline uint32_t crumbParticles(double particles) {
    const auto share = static_cast<uint32_t>(kCrumbShare * particles);
    return share > kCrumbParticles ? share : kCrumbParticles;
}

/// A meeting at this share of the body's threshold velocity or more brings the bonds back before the two
/// touch, if the body itself hits something fixed. The threshold is that of a whole body; what has cracked
/// already, or comes down turning, breaks from less of it on: of the bonds that a shot wolf loses a fifth
/// were in pieces that would have stayed rigid at 0.7, a seventh at 0.5, three in a hundred at 0.35. What is
/// lighter must come faster, by the fourth root of the mass: by the square root if the energy alone decided,
/// not at all if the stress at the spot did.
inline constexpr double kWakeShare = 0.35;

/// Above both of these speeds (m/s) a meeting is hard: `heavy` if the reduced number of particles is that of
/// the whole body, `body`, or more; `light` over the root of the reduced number, since a crumb of one
/// particle loads the bonds where it hits by v / (beta v_c) of their strength at most.
template <class Real>
struct WakeLaw {
    Real heavy{}, light{};
    Real body{};  ///< particles
};

/// At rest: no particle faster than kRestSpeed (m/s) for kRestSeconds (models E.4).
inline constexpr double kRestSpeed = 0.02, kRestSeconds = 0.25;

/// m/s.
inline double calmSpeed(double beta, double critical_velocity) {
    return kCalmShare * beta * critical_velocity;
}
inline WakeLaw<double> wakeLaw(double beta, double critical_velocity, double threshold_share,
                               double particles) {
    return {kWakeShare * threshold_share * critical_velocity, beta * critical_velocity, particles};
}

/// Of bodies with preset pieces: what would break the weakest of them as a whole brings its pieces apart.
inline WakeLaw<double> releaseLaw(double beta, double critical_velocity, double threshold_share,
                                  double particles) {
    return {threshold_share * critical_velocity, beta * critical_velocity, particles};
}

/// m/s, between pieces of n_i and n_j particles.
template <class Real>
DEM_FN Real wakeSpeed(const WakeLaw<Real>& a, const WakeLaw<Real>& b, Real n_i, Real n_j) {
    const Real inverse_number = (n_i + n_j) / (n_i * n_j), lightness = minOf(a.body, b.body) * inverse_number;
    const Real slower = lightness > Real(1) ? squareRoot(squareRoot(lightness)) : Real(1);
    return maxOf(slower * minOf(a.heavy, b.heavy), minOf(a.light, b.light) * squareRoot(inverse_number));
}

}  // namespace demolish
