// SPDX-License-Identifier: Apache-2.0
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

/// e in 0.05..1 (clamped to it). The rows were integrated numerically (e = 0.05 in the same way as the
/// sheet's). Between them the ratio to the closed form of the unclamped law, -ln e/sqrt(ln^2 e+pi^2), is
/// interpolated; at e = 1 both are 0.
inline RestitutionConstants restitutionConstants(double e) {
    constexpr int kRows = 10;
    constexpr std::array<double, kRows> kRestitution{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
    constexpr std::array<double, kRows> kHertz{4.3499, 2.7796, 1.6350, 1.1118, 0.7927,
                                               0.5708, 0.4044, 0.2733, 0.1663, 0.0766};
    constexpr std::array<double, kRows> kLinear{3.8906, 2.4865, 1.4626, 0.9945, 0.7091,
                                                0.5106, 0.3617, 0.2444, 0.1487, 0.0685};
    const auto unclamped = [](double value) {
        const double l = std::log(value);
        return -l / std::sqrt(l * l + 3.14159265358979323846 * 3.14159265358979323846);
    };
    e = e < kRestitution.front() ? kRestitution.front() : (e > 1 ? 1.0 : e);
    int row = 0;
    while (row < kRows - 2 && e > kRestitution[row + 1]) ++row;
    const double fraction = (e - kRestitution[row]) / (kRestitution[row + 1] - kRestitution[row]);
    const auto value = [&](const std::array<double, kRows>& table) {
        const double low = table[row] / unclamped(kRestitution[row]);
        return unclamped(e) * (low + fraction * (table[row + 1] / unclamped(kRestitution[row + 1]) - low));
    };
    return {value(kHertz), value(kLinear)};
}

}  // namespace demolish
