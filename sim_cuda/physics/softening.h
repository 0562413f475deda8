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
/// E_b that gives E_eff (inverse of (E4)), Pa: for a body that is not softened.
inline double bondModulusFor(double effective_modulus, double shear_ratio) {
    return effective_modulus * (4 + shear_ratio) / (2 + 3 * shear_ratio);
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

/// E.2 fits for a 1 m sphere, D/h = 9.8..20 measured; D = diameter of the sphere of equal volume, h =
/// (V/N)^(1/3).
inline double calibratedBeta(double diameter_over_spacing) {
    return 0.66 * std::pow(diameter_over_spacing / 12.4, 0.36);
}
/// The same with 40 tough cells of factor 3.
inline double calibratedBetaToughCells(double diameter_over_spacing) {
    return 0.37 * std::pow(diameter_over_spacing / 12.4, 0.23);
}
/// D/h of a body of N particles: (6/pi)^(1/3) N^(1/3).
inline double diameterOverSpacing(double particles) {
    return std::cbrt(6 * particles / 3.14159265358979323846);
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

/// Substeps per 1/60 s that keep the strain at failure at eps_c: beta v_c/(eps_c kappa sf 60 h); kappa =
/// 0.65..0.72, h in m.
inline double substepsForStrain(double beta, double critical_velocity, double strain, double safety,
                                double spacing, double kappa = 0.68) {
    return beta * critical_velocity / (strain * kappa * safety * 60 * spacing);
}

/// What kind of body is hit, and how: rows of the threshold table of E.2.
enum class ThresholdCase {
    kSphereDrop,
    kRabbitDrop,
    kRabbitBall,
    kVaseDrop,
    kVaseBall,
    kColumnBall,
    kWolfBall,
};
/// f in v_th = f v_c: mean of the two packings measured with N = 1500, K = 50, ci = 3, beta = 0.4; the
/// sphere's is 1 by the definition of v_c.
inline double thresholdFactor(ThresholdCase which) {
    switch (which) {
        case ThresholdCase::kRabbitDrop:
            return 0.60;
        case ThresholdCase::kRabbitBall:
            return 3.45;
        case ThresholdCase::kVaseDrop:
            return 0.22;
        case ThresholdCase::kVaseBall:
            return 8.9;
        case ThresholdCase::kColumnBall:
            return 0.75;
        case ThresholdCase::kWolfBall:
            return 1.205;
        case ThresholdCase::kSphereDrop:
            break;
    }
    return 1.0;
}

}  // namespace demolish
