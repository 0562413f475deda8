// SPDX-License-Identifier: Apache-2.0
// Sampled evenly, continued by point reflection at open ends.
#include "tests/unit/cracks/crack_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demolish::test {
namespace {

using std::ptrdiff_t;

constexpr double kStep = 0.1;  ///< h

std::vector<Double3> sampled(const std::vector<Double3>& line, double step) {
    std::vector<Double3> samples;
    double left = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        const Double3 way = line[i + 1] - line[i];
        const double part = length(way);
        if (part <= 0) continue;
        for (; left <= part; left += step) samples.push_back(line[i] + way * (left / part));
        left -= part;
    }
    return samples;
}

Double3 continued(const std::vector<Double3>& line, ptrdiff_t i, bool closed) {
    const auto n = static_cast<ptrdiff_t>(line.size());
    if (closed) return line[static_cast<size_t>(((i % n) + n) % n)];
    const auto inside = [&](ptrdiff_t k) {
        return line[static_cast<size_t>(std::clamp<ptrdiff_t>(k, 0, n - 1))];
    };
    if (i < 0) return 2.0 * line.front() - inside(-i);
    if (i >= n) return 2.0 * line.back() - inside(2 * (n - 1) - i);
    return inside(i);
}

std::vector<Double3> smoothed(const std::vector<Double3>& line, bool closed) {
    const ptrdiff_t reach = std::min<ptrdiff_t>(ptrdiff_t(4 / kStep), ptrdiff_t(line.size()) - 1);
    std::vector<Double3> smooth;
    for (ptrdiff_t i = 0; i < ptrdiff_t(line.size()); ++i) {
        Double3 sum;
        double weights = 0;
        for (ptrdiff_t k = -reach; k <= reach; ++k) {
            const double x = double(k) * kStep, weight = std::exp(-0.5 * x * x);
            sum += continued(line, i + k, closed) * weight;
            weights += weight;
        }
        smooth.push_back(sum * (1 / weights));
    }
    return smooth;
}

}  // namespace

LineMeasure measureLines(const std::vector<std::vector<Double3>>& lines, double h) {
    LineMeasure measure;
    double squares = 0, count = 0, turned = 0;
    for (const auto& corners : lines) {
        const std::vector<Double3> line = sampled(corners, kStep * h);
        if (double(line.size()) * kStep < 3) continue;
        const bool closed = length(corners.front() - corners.back()) < 1e-6 * h;
        const std::vector<Double3> smooth = smoothed(line, closed);
        for (size_t i = 0; i < line.size(); ++i) {
            const Double3 along =
                normalized(smooth[std::min(i + 1, line.size() - 1)] - smooth[i > 0 ? i - 1 : 0]);
            const Double3 off = line[i] - smooth[i];
            squares += std::max(0.0, lengthSquared(off) - dot(off, along) * dot(off, along));
            count += 1;
        }
        for (size_t i = 1; i + 1 < line.size(); ++i) {
            const Double3 a = normalized(line[i] - line[i - 1]), b = normalized(line[i + 1] - line[i]);
            turned += std::acos(std::clamp(dot(a, b), -1.0, 1.0));
        }
        measure.length += double(line.size() - 1) * kStep;
    }
    measure.deviation = count > 0 ? std::sqrt(squares / count) / h : 0;
    measure.turning = measure.length > 0 ? turned / measure.length : 0;
    return measure;
}

}  // namespace demolish::test
