// SPDX-License-Identifier: Apache-2.0
#include "engine/render/hidden_triangles.h"

#include <algorithm>
#include <cmath>

namespace demolish::engine {

NearPlane::NearPlane(const std::array<PicturePoint, 3>& corners)
    : x_(corners[0].x), y_(corners[0].y), near_(corners[0].near) {
    const auto& [a, b, c] = corners;
    const float to_b = b.near - a.near, to_c = c.near - a.near;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    slope_x_ = (to_b * (c.y - a.y) - to_c * (b.y - a.y)) / area;
    slope_y_ = (to_c * (b.x - a.x) - to_b * (c.x - a.x)) / area;
    least_ = std::min({a.near, b.near, c.near});
    most_ = std::max({a.near, b.near, c.near});
    const float unsure_place = std::max({a.unsure, b.unsure, c.unsure});
    unsure_ = unsure_place * (std::abs(slope_x_) + std::abs(slope_y_)) +
              std::max({a.near_unsure, b.near_unsure, c.near_unsure});
}

void Candidates::clear() {
    triangles_.clear();
    samples_.clear();
}

void Candidates::add(const uint32_t (&corners)[3], const std::array<PicturePoint, 3>& places,
                     const Cover& cover, const SampleGrid& grid, NearestSurely& nearest) {
    const size_t before = samples_.size();
    const NearPlane plane(places);
    const bool is_whole = plane.most() + plane.unsure() < 1;  // the near plane cuts nothing off
    grid.anySample(cover, [&](float x, float y, size_t sample) {
        if (!cover.mayCover(x, y)) return false;
        const float near = plane.at(x, y);
        const auto index = static_cast<uint32_t>(sample);
        samples_.push_back({index, near + plane.unsure()});
        if (is_whole && near > plane.unsure() && cover.surelyCovers(x, y))
            nearest.put(index, near - plane.unsure());
        return false;
    });
    const size_t samples = samples_.size() - before;
    triangles_.push_back({{corners[0], corners[1], corners[2]}, static_cast<uint32_t>(samples)});
}

void Candidates::keepSeen(const NearestSurely& nearest, std::vector<uint32_t>& indices) const {
    auto sample = samples_.begin();
    for (const Candidate& triangle : triangles_) {
        const auto end = sample + triangle.samples;
        const auto shows = [&](const Sample& s) { return !nearest.hides(s.index, s.nearest); };
        if (triangle.samples == 0 || std::any_of(sample, end, shows))
            indices.insert(indices.end(), triangle.corners, triangle.corners + 3);
        sample = end;
    }
}

}  // namespace demolish::engine
