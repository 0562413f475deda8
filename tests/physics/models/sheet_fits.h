// SPDX-License-Identifier: Apache-2.0
// What the sheets' prototype measured and no scene is set up by (models.md E.2): the strength of a 1 m sphere
// over the particle size.
#pragma once
#include <cmath>

namespace demolish::tests {

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

}  // namespace demolish::tests
