// SPDX-License-Identifier: Apache-2.0
// Sampled evenly, continued by point reflection at open ends.
#include "app/compare/crack_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demolish {
namespace {

using std::ptrdiff_t;

constexpr double kStep = 0.1;  ///< h

/// Unit, or null where the vector is.
glm::dvec3 direction(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

Line sampled(const Line& line, double step) {
    Line samples;
    double left = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        const LineCorner &from = line[i], &to = line[i + 1];
        const double part = glm::length(to.place - from.place);
        if (part <= 0) continue;
        for (; left <= part; left += step)
            samples.push_back({glm::mix(from.place, to.place, left / part),
                               direction(glm::mix(from.normal, to.normal, left / part))});
        left -= part;
    }
    return samples;
}

glm::dvec3 continued(const Line& line, ptrdiff_t i, bool closed) {
    const auto n = static_cast<ptrdiff_t>(line.size());
    if (closed) return line[static_cast<size_t>(((i % n) + n) % n)].place;
    const auto inside = [&](ptrdiff_t k) {
        return line[static_cast<size_t>(std::clamp<ptrdiff_t>(k, 0, n - 1))].place;
    };
    if (i < 0) return 2.0 * line.front().place - inside(-i);
    if (i >= n) return 2.0 * line.back().place - inside(2 * (n - 1) - i);
    return inside(i);
}

std::vector<glm::dvec3> smoothed(const Line& line, bool closed) {
    const ptrdiff_t reach = std::min<ptrdiff_t>(ptrdiff_t(4 / kStep), ptrdiff_t(line.size()) - 1);
    std::vector<glm::dvec3> smooth;
    for (ptrdiff_t i = 0; i < ptrdiff_t(line.size()); ++i) {
        glm::dvec3 sum(0);
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

LineMeasure measureLines(const std::vector<Line>& lines, double h) {
    LineMeasure measure;
    double squares = 0, sideways = 0, count = 0, turned = 0;
    for (const auto& corners : lines) {
        const Line line = sampled(corners, kStep * h);
        if (double(line.size()) * kStep < 3) continue;
        const bool closed = glm::length(corners.front().place - corners.back().place) < 1e-6 * h;
        const std::vector<glm::dvec3> smooth = smoothed(line, closed);
        for (size_t i = 0; i < line.size(); ++i) {
            const glm::dvec3 along =
                direction(smooth[std::min(i + 1, line.size() - 1)] - smooth[i > 0 ? i - 1 : 0]);
            const glm::dvec3 off = line[i].place - smooth[i];
            const double aside = glm::dot(off, direction(glm::cross(line[i].normal, along)));
            squares += std::max(0.0, glm::dot(off, off) - glm::dot(off, along) * glm::dot(off, along));
            sideways += aside * aside;
            count += 1;
        }
        for (size_t i = 1; i + 1 < line.size(); ++i) {
            const glm::dvec3 a = direction(line[i].place - line[i - 1].place),
                             b = direction(line[i + 1].place - line[i].place);
            turned += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
        }
        measure.length += double(line.size() - 1) * kStep;
    }
    measure.deviation = count > 0 ? std::sqrt(squares / count) / h : 0;
    measure.sideways = count > 0 ? std::sqrt(sideways / count) / h : 0;
    measure.turning = measure.length > 0 ? turned / measure.length : 0;
    return measure;
}

}  // namespace demolish
