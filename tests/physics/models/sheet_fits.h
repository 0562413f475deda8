// SPDX-License-Identifier: Apache-2.0
// What the sheets' prototype measured and no scene is set up by (models.md E.2): the strength of a 1 m sphere
// over the particle size, and the thresholds of the four models.
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

}  // namespace demolish::tests
