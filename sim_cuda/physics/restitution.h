// Set-up: the damper constants that give a wanted restitution with the clamped contact force (table of
// physics A.2).
#pragma once
#include <array>
#include <cmath>

namespace demolish {

struct RestitutionConstants {
    double hertz = 0;   ///< alpha of the Hertz damper
    double linear = 0;  ///< c^ of the linear damper
};

/// e in 0.05..1 (clamped to it). Between the rows of the table, which was integrated numerically, alpha /
/// alpha0 is interpolated linearly in e, alpha0 = -ln e/sqrt(ln^2 e+pi^2) being the closed form of the
/// unclamped law; at e = 1 both are 0.
inline RestitutionConstants restitutionConstants(double e) {
    constexpr std::array<double, 9> kHertz{2.7796, 1.6350, 1.1118, 0.7927, 0.5708,
                                           0.4044, 0.2733, 0.1663, 0.0766};
    constexpr std::array<double, 9> kLinear{2.4865, 1.4626, 0.9945, 0.7091, 0.5106,
                                            0.3617, 0.2444, 0.1487, 0.0685};
    const auto unclamped = [](double value) {
        const double l = std::log(value);
        return -l / std::sqrt(l * l + 3.14159265358979323846 * 3.14159265358979323846);
    };
    e = e < 0.05 ? 0.05 : (e > 1 ? 1.0 : e);
    const double at = e * 10 - 1;
    const int row = at < 0 ? 0 : (at > 7 ? 7 : static_cast<int>(at));
    const double fraction = at - row;
    const auto value = [&](const std::array<double, 9>& table) {
        const double low = table[row] / unclamped(0.1 * (row + 1)),
                     high = table[row + 1] / unclamped(0.1 * (row + 2));
        return unclamped(e) * (low + fraction * (high - low));
    };
    return {value(kHertz), value(kLinear)};
}

}  // namespace demolish
