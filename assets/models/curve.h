// SPDX-License-Identifier: Apache-2.0
// A smooth curve through given points.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace demolish::sculptor {

/// Cubic Hermite curve through (x, y) with the slopes of the parabola through each point and its neighbours.
class Curve {
  public:
    Curve(const std::vector<double>& x, const std::vector<double>& y) : x_(x), y_(y), slope_(x.size()) {
        const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
        const std::size_t last = x.size() - 1;
        for (std::size_t i = 1; i < last; ++i) {
            const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
            slope_[i] = (after * secant(i - 1) + before * secant(i)) / (before + after);
        }
        slope_[0] = 2 * secant(0) - slope_[1];
        slope_[last] = 2 * secant(last - 1) - slope_[last - 1];
    }

    double at(double x) const {
        const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
        const std::size_t i = static_cast<std::size_t>(above - x_.begin()) - 1;
        const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h, u = 1 - t;
        return u * u * ((1 + 2 * t) * y_[i] + t * h * slope_[i]) +
               t * t * ((1 + 2 * u) * y_[i + 1] - u * h * slope_[i + 1]);
    }

  private:
    std::vector<double> x_, y_, slope_;
};

}  // namespace demolish::sculptor
