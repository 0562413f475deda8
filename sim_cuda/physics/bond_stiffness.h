// SPDX-License-Identifier: Apache-2.0
// Set-up of one solid bond's four constants: the paper's (5)-(10) and (13) as corrected in physics A.3-A.4,
// and the beam law of models E.1. Host code in double; out-of-range input throws std::invalid_argument.
#pragma once
#include <cmath>
#include <stdexcept>

#include "sim_cuda/physics/bond_laws.h"

namespace demolish {

/// The formulas alone, for input that is known to be in range; either side computes them.
namespace bond_formula {
/// g of (7'), (8').
DEM_FN double coupling(double ratio, double nu) {
    return kPi / 6 * (1 - nu * nu) * (1 + 2 * ratio) - ratio;
}
DEM_FN double normalDenominator(double ratio, double nu, double psi) {
    return std::sqrt(1 - ratio * ratio) - psi * (ratio + ratio * ratio * coupling(ratio, nu));
}
DEM_FN double normalCorrection(double ratio, double nu, double psi = 0) {
    return (1 + ratio * coupling(ratio, nu)) / normalDenominator(ratio, nu, psi);
}
DEM_FN double shearCorrection(double ratio, double nu) {
    return normalCorrection(ratio, nu, 0);
}
DEM_FN BondStiffness<double> paperBond(double E, double nu, double ratio, double radius, double psi = 0) {
    const double k_n = E / (1 - nu * nu) * normalCorrection(ratio, nu, psi) * radius;
    const double k_t = 2 * E / ((2 - nu) * (1 + nu)) * shearCorrection(ratio, nu) * radius;
    return {k_n, k_t, k_n * radius * radius / 4, k_t * radius * radius / 2};
}
DEM_FN BondStiffness<double> beamBond(double E_b, double area, double length, double shear_ratio = 0.3) {
    const double k_n = E_b * area / length, k_b = E_b * area * area / (4 * kPi * length);
    return {k_n, shear_ratio * k_n, k_b, 2 * shear_ratio * k_b};
}
DEM_FN double griffithStrength(double E, double nu, double fracture_energy, double radius) {
    return std::sqrt(E * fracture_energy / ((1 - nu * nu) * kPi * radius));
}
}  // namespace bond_formula

namespace bond_detail {
inline void demand(bool condition, const char* what) {
    if (!condition) throw std::invalid_argument(what);
}
inline void demandRatio(double ratio, double nu, double psi) {
    demand(ratio > 0 && ratio < 1, "bond radius ratio a* must lie between 0 and 1");
    demand(nu >= 0 && nu < 0.5, "Poisson ratio must lie between 0 and 0.5");
    demand(psi >= 0, "bond interaction psi must not be negative");
    demand(bond_formula::normalDenominator(ratio, nu, psi) > 0,
           "bond interaction psi is too large for this bond radius ratio a*");
}
}  // namespace bond_detail

/// (7') f_N = B / (sqrt(1-a*^2) - psi (a* + a*^2 g)), B = 1 + a* g. Ratio a* in (0, 1), useful 0.3..0.7; 0 <=
/// nu < 0.5; psi >= 0 (0: no interaction of bonds inside a particle) must leave the denominator positive.
inline double normalCorrection(double ratio, double nu, double psi = 0) {
    bond_detail::demandRatio(ratio, nu, psi);
    return bond_formula::normalCorrection(ratio, nu, psi);
}
/// (8') f_T = B / sqrt(1-a*^2); same ranges.
inline double shearCorrection(double ratio, double nu) {
    return normalCorrection(ratio, nu, 0);
}

/// a_b = 2 a* R*, m: of two spheres (physics A.3; equal spheres: a* R).
inline double sphereBondRadius(double ratio, double reduced_radius) {
    return 2 * ratio * reduced_radius;
}
/// a_b = sqrt(A/pi), m: of a shared face of area A, m^2 (E.1).
inline double faceBondRadius(double area) {
    return std::sqrt(area / kPi);
}
/// Reading P1 of a* on a face: min(2 a_b/L, 0.9); radius and length in m.
inline double faceRatioClamped(double radius, double length) {
    return std::fmin(2 * radius / length, 0.9);
}
/// Reading P2 of a* on a face: a_b/sqrt(L^2/4 + a_b^2), two spheres cut by a neck a_b at distance L; always
/// below 1.
inline double faceRatioNeck(double radius, double length) {
    return radius / std::sqrt(length * length / 4 + radius * radius);
}

/// (5')-(10'): k_N = E/(1-nu^2) f_N a_b, k_T = 2E/((2-nu)(1+nu)) f_T a_b, k_P = k_T a_b^2/2, k_B = k_N
/// a_b^2/4. E in Pa, radius a_b in m, ratio a* and psi as in normalCorrection.
inline BondStiffness<double> paperBond(double E, double nu, double ratio, double radius, double psi = 0) {
    bond_detail::demand(E > 0 && radius > 0, "bond modulus and radius must be positive");
    bond_detail::demandRatio(ratio, nu, psi);
    return bond_formula::paperBond(E, nu, ratio, radius, psi);
}

/// (E1): k_N = E_b A/L, k_T = a k_N, k_B = E_b I_b/L, k_P = 2 a k_B, I_b = A^2/(4 pi). E_b in Pa, A in m^2, L
/// in m; shear ratio a = k_T/k_N in 0..1, 0.3 by default.
inline BondStiffness<double> beamBond(double E_b, double area, double length, double shear_ratio = 0.3) {
    bond_detail::demand(E_b > 0 && area > 0 && length > 0, "bond modulus, area and length must be positive");
    bond_detail::demand(shear_ratio >= 0 && shear_ratio <= 1, "shear ratio must lie between 0 and 1");
    return bond_formula::beamBond(E_b, area, length, shear_ratio);
}

/// (13) sigma_c = sqrt(E Gamma/((1-nu^2) pi a_b)), Pa; Gamma in J/m^2, a calibration constant within a factor
/// 4 of the true surface work (physics A.4).
inline double griffithStrength(double E, double nu, double fracture_energy, double radius) {
    bond_detail::demand(E > 0 && fracture_energy >= 0 && radius > 0,
                        "modulus and bond radius must be positive");
    return bond_formula::griffithStrength(E, nu, fracture_energy, radius);
}

}  // namespace demolish
