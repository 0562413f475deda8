// SPDX-License-Identifier: Apache-2.0
// How stiff and how strong a body may be for a given number of substeps: the scaling rule of physics C.3 with
// the numbers of models E.1-E.2. Host code in double, SI units.
#pragma once
#include <cmath>

namespace demolish {

/// E.1: E_b = E_1 (2 sf/(dt omega_1))^2, Pa: the bond modulus at which dt is `safety` times the critical
/// step, when the trial modulus E_1 (Pa) gave the highest frequency omega_1 (rad/s).
inline double bondModulusForStep(double trial_modulus, double trial_omega, double safety, double dt) {
    const double ratio = 2 * safety / (dt * trial_omega);
    return trial_modulus * ratio * ratio;
}

/// (E4) E_eff = E_b (2+3a)/(4+a), Pa, of the beam law; a = k_T/k_N. 0.674 E_b at a = 0.3.
inline double effectiveModulus(double bond_modulus, double shear_ratio) {
    return bond_modulus * (2 + 3 * shear_ratio) / (4 + shear_ratio);
}
/// E_eff of the paper's law on faces, reading P2: 1.456 E_b, the mean of four measured bars (E.1 table, nu =
/// 0.25).
inline double effectiveModulusPaper(double bond_modulus) {
    return 1.456 * bond_modulus;
}
/// (E4) c_eff = sqrt(E_eff/rho), m/s.
inline double waveSpeed(double effective_modulus, double density) {
    return std::sqrt(effective_modulus / density);
}

/// E.2: sigma_c = beta rho c_eff v_c, Pa; v_c = critical velocity of the material, m/s.
inline double bondStrength(double beta, double density, double wave_speed, double critical_velocity) {
    return beta * density * wave_speed * critical_velocity;
}
/// eps_c = sigma_c/E_eff; above 0.03 a body looks like rubber.
inline double strainAtFailure(double strength, double effective_modulus) {
    return strength / effective_modulus;
}

/// 2 V/(A h): mean thickness of a body's walls in cells; of a rod half, of a ball a third of its diameter.
/// Volume in m^3, area of the surface in m^2, h in m, all > 0.
inline double cellsThroughWall(double volume, double area, double spacing) {
    return 2 * volume / (area * spacing);
}
/// Share of the strength by E.2 that holds the critical velocity of a thin-walled body at every particle
/// size: 1 from 1.2 cells through the wall on. Below, one layer of cells that are wider than the wall is
/// thick breaks too late: a vase by (1.2/cells)^0.8 in speed when dropped and more when hit, plates and tubes
/// by (1.2/cells)^0.35 (docs/measurements/thresholds.md). Not measured below 0.6 cells: stays there.
inline double thinWallShare(double cells) {
    constexpr double kMeasured = 0.6, kThin = 1.2, kExponent = 0.75;
    return cells < kThin ? std::pow(std::fmax(cells, kMeasured) / kThin, kExponent) : 1;
}

}  // namespace demolish
