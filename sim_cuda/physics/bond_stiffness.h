// SPDX-License-Identifier: Apache-2.0
// Set-up of one solid bond: the paper's (5)-(8) and (13) as corrected in physics A.3-A.4, and the beam law of
// models E.1. Host code in double; out-of-range input throws std::invalid_argument.
#pragma once
#include <cmath>
#include <stdexcept>

#include "sim_cuda/physics/bond_laws.h"

namespace demolish {

namespace bond_detail {
inline void demand(bool condition, const char* what) {
    if (!condition) throw std::invalid_argument(what);
}
inline void demandPoissonRatio(double nu) {
    demand(nu >= 0 && nu < 0.5, "Poisson ratio must lie between 0 and 0.5");
}
}  // namespace bond_detail

/// g of (7'), (8'): (pi/6) (1-nu^2) (1 + 2 a*) - a*. Ratio a* in (0, 1), useful 0.3..0.7; 0 <= nu < 0.5.
inline double bondCoupling(double ratio, double nu) {
    bond_detail::demand(ratio > 0 && ratio < 1, "bond radius ratio a* must lie between 0 and 1");
    bond_detail::demandPoissonRatio(nu);
    return kPi / 6 * (1 - nu * nu) * (1 + 2 * ratio) - ratio;
}
/// (7') and (8'): f_N = f_T = (1 + a* g) / sqrt(1-a*^2), without interaction of bonds inside a particle
/// (psi = 0; with it: paper_forms.h).
inline double normalCorrection(double ratio, double nu) {
    return (1 + ratio * bondCoupling(ratio, nu)) / std::sqrt(1 - ratio * ratio);
}
/// (5') and (6'): k_T / k_N = 2 (1-nu) / (2-nu), since f_N = f_T.
inline double paperShearRatio(double nu) {
    bond_detail::demandPoissonRatio(nu);
    return 2 * (1 - nu) / (2 - nu);
}

/// a_b = 2 a* R*, m: of two spheres of radii R_i, R_j (physics A.3; equal spheres: a* R).
inline double sphereBondRadius(double ratio, double radius_i, double radius_j) {
    return 2 * ratio * radius_i * radius_j / (radius_i + radius_j);
}
/// a_b = sqrt(A/pi), m: of a shared face of area A, m^2 (E.1).
inline double faceBondRadius(double area) {
    return std::sqrt(area / kPi);
}
/// Reading P2 of a* on a face: a_b/sqrt(L^2/4 + a_b^2), two spheres cut by a neck a_b at distance L; always
/// below 1.
inline double faceRatioNeck(double radius, double length) {
    return radius / std::sqrt(length * length / 4 + radius * radius);
}

/// (5')-(10'): k_N = E/(1-nu^2) f_N a_b, the others by roundBond(). E in Pa, radius a_b in m, ratio a* as in
/// normalCorrection().
inline BondStiffness<double> paperBond(double E, double nu, double ratio, double radius) {
    bond_detail::demand(E > 0 && radius > 0, "bond modulus and radius must be positive");
    return roundBond(E / (1 - nu * nu) * normalCorrection(ratio, nu) * radius, paperShearRatio(nu), radius);
}

/// (E1): k_N = E_b A/L, the others by roundBond(): k_B = E_b I_b/L, I_b = A^2/(4 pi). E_b in Pa, A in m^2, L
/// in m; shear ratio a = k_T/k_N in 0..1, 0.3 by default.
inline BondStiffness<double> beamBond(double E_b, double area, double length, double shear_ratio = 0.3) {
    bond_detail::demand(E_b > 0 && area > 0 && length > 0, "bond modulus, area and length must be positive");
    bond_detail::demand(shear_ratio >= 0 && shear_ratio <= 1, "shear ratio must lie between 0 and 1");
    return roundBond(E_b * area / length, shear_ratio, faceBondRadius(area));
}

/// (13) sigma_c = sqrt(E Gamma/((1-nu^2) pi a_b)), Pa; Gamma in J/m^2, a calibration constant within a factor
/// 4 of the true surface work (physics A.4).
inline double griffithStrength(double E, double nu, double fracture_energy, double radius) {
    bond_detail::demand(E > 0 && fracture_energy >= 0 && radius > 0,
                        "modulus and bond radius must be positive");
    return std::sqrt(E * fracture_energy / ((1 - nu * nu) * kPi * radius));
}

}  // namespace demolish
