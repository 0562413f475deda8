// SPDX-License-Identifier: Apache-2.0
// The triangles between the rings of a turned body.
#include "assets/models/revolve.h"

#include <cmath>
#include <utility>

namespace demolish::sculptor {
namespace {

/// Distance along the profile from the first pole to each ring and the last pole, the whole being 1.
std::vector<double> profileDistances(const std::vector<TurnedRing>& rings, double last_pole) {
    std::vector<double> distances;
    double sum = 0, r = 0, y = rings.front().y;
    const auto walkTo = [&](double next_r, double next_y) {
        sum += std::hypot(next_r - r, next_y - y);
        distances.push_back(sum);
        r = next_r, y = next_y;
    };
    for (const TurnedRing& ring : rings) walkTo(ring.radius, ring.y);
    walkTo(0, last_pole);
    for (double& d : distances) d /= sum;
    return distances;
}

}  // namespace

Turned revolve(const std::vector<TurnedRing>& rings, double last_pole) {
    Turned turned;
    const auto v = profileDistances(rings, last_pole);
    const int count = static_cast<int>(rings.size()), sectors = static_cast<int>(rings[0].points.size());
    auto& positions = turned.surface.positions;
    positions.push_back({0, rings.front().y, 0});
    for (const TurnedRing& ring : rings)
        positions.insert(positions.end(), ring.points.begin(), ring.points.end());
    positions.push_back({0, last_pole, 0});
    using Corner = std::pair<std::uint32_t, std::array<double, 2>>;
    const auto corner = [&](int ring, int s) -> Corner {
        if (ring < 0) return {0, {0.5, 0}};
        if (ring == count) return {static_cast<std::uint32_t>(positions.size() - 1), {0.5, 1}};
        return {1 + static_cast<std::uint32_t>(ring * sectors + s % sectors), {double(s) / sectors, v[ring]}};
    };
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
        turned.surface.triangles.push_back({a.first, b.first, c.first});
        turned.uvs.push_back({a.second, b.second, c.second});
    };
    for (int ring = -1; ring < count; ++ring)
        for (int s = 0; s < sectors; ++s) {
            if (ring >= 0) add(corner(ring, s), corner(ring + 1, s), corner(ring, s + 1));
            if (ring + 1 < count) add(corner(ring, s + 1), corner(ring + 1, s), corner(ring + 1, s + 1));
        }
    return turned;
}

}  // namespace demolish::sculptor
