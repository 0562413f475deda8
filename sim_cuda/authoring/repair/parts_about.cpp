// SPDX-License-Identifier: Apache-2.0
// Lines along x collect what they cross, by blocks of layers; a line that grazes an edge leaves its points to
// rays.
#include "sim_cuda/authoring/repair/parts_about.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/planar_side.h"

namespace demolish {
namespace {

/// Where a line passes a part's surface.
struct PartCrossing {
    uint32_t part;
    int direction;  // 1 out of the part, -1 into it
    double x;       // m
};

/// Points with y and z in common.
struct Line {
    double y, z;         // m
    size_t first, past;  // points
    bool is_grazed = false;
    std::vector<PartCrossing> crossings;

    void cross(const Double3& a, const Double3& b, const Double3& c, uint32_t part) {
        const double u = edgeSide(b.y - y, b.z - z, c.y - y, c.z - z),
                     v = edgeSide(c.y - y, c.z - z, a.y - y, a.z - z),
                     w = edgeSide(a.y - y, a.z - z, b.y - y, b.z - z);
        if ((u > 0 || v > 0 || w > 0) && (u < 0 || v < 0 || w < 0)) return;
        is_grazed = is_grazed || u == 0 || v == 0 || w == 0;
        crossings.push_back({part, u > 0 ? 1 : -1, (u * a.x + v * b.x + w * c.x) / (u + v + w)});
    }

    /// `crossings` sorted by part.
    std::vector<uint32_t> partsAbout(double at) const {
        std::vector<uint32_t> about;
        for (size_t begin = 0, end = 0; begin < crossings.size(); begin = end) {
            int winding = 0;
            for (; end < crossings.size() && crossings[end].part == crossings[begin].part; ++end)
                winding += crossings[end].x > at ? crossings[end].direction : 0;
            if (winding > 0) about.push_back(crossings[begin].part);
        }
        return about;
    }
};

/// Lines of one z follow each other, by their y.
std::vector<Line> linesThrough(const std::vector<Double3>& points) {
    std::vector<Line> lines;
    for (size_t i = 0; i < points.size(); ++i) {
        if (lines.empty() || lines.back().y != points[i].y || lines.back().z != points[i].z)
            lines.push_back({points[i].y, points[i].z, i, i, false, {}});
        lines.back().past = i + 1;
    }
    return lines;
}

/// The lines from `first` to `end`, whose layers no other task has.
void crossMesh(const RepairMesh& repair, std::vector<Line>& lines, size_t first, size_t end) {
    const auto begin_line = lines.begin() + std::ptrdiff_t(first),
               end_line = lines.begin() + std::ptrdiff_t(end);
    for (size_t t = 0; t < repair.size(); ++t) {
        const Double3 &a = repair.at(t, 0), &b = repair.at(t, 1), &c = repair.at(t, 2);
        const auto [z_low, z_high] = std::minmax({a.z, b.z, c.z});
        if (z_high < begin_line->z || z_low > (end_line - 1)->z) continue;
        const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
        const auto isBelow = [](const Line& line, const std::pair<double, double>& zy) {
            return std::pair(line.z, line.y) < zy;
        };
        for (auto line = std::lower_bound(begin_line, end_line, std::pair(z_low, y_low), isBelow);
             line != end_line && line->z <= z_high;) {
            if (line->y < y_low) {
                line = std::lower_bound(line, end_line, std::pair(line->z, y_low), isBelow);
            } else if (line->y > y_high) {
                const double z = line->z;
                line = std::partition_point(line, end_line, [&](const Line& other) { return other.z <= z; });
            } else {
                line->cross(a, b, c, repair.part[t]);
                ++line;
            }
        }
    }
    for (auto line = begin_line; line != end_line; ++line)
        std::stable_sort(
            line->crossings.begin(), line->crossings.end(),
            [](const PartCrossing& one, const PartCrossing& other) { return one.part < other.part; });
}

}  // namespace

const MeshQueries& PartsAbout::queries() {
    if (!queries_) queries_.emplace(repair_.mesh);
    return *queries_;
}

std::vector<uint32_t> PartsAbout::aboutByRay(const Double3& point) const {
    std::vector<uint32_t> about;
    std::vector<std::pair<uint32_t, int>> crossed;  // part, direction
    for (const auto& [triangle, direction] : queries_->crossings(point))
        crossed.emplace_back(repair_.part[triangle], direction);
    std::sort(crossed.begin(), crossed.end());
    for (size_t begin = 0, end = 0; begin < crossed.size(); begin = end) {
        int winding = 0;
        for (; end < crossed.size() && crossed[end].first == crossed[begin].first; ++end)
            winding += crossed[end].second;
        if (winding > 0) about.push_back(crossed[begin].first);
    }
    return about;
}

std::vector<std::vector<uint32_t>> PartsAbout::each(const std::vector<Double3>& points) {
    std::vector<std::vector<uint32_t>> about(points.size());
    if (points.empty()) return about;
    queries();
    tbb::parallel_for(size_t(0), points.size(), [&](size_t i) { about[i] = aboutByRay(points[i]); });
    return about;
}

std::vector<std::vector<uint32_t>> PartsAbout::eachOfGrid(const std::vector<Double3>& points) {
    constexpr size_t kBlocks = 8;  // each looks at all triangles
    std::vector<Line> lines = linesThrough(points);
    tbb::parallel_for(size_t(0), kBlocks, [&](size_t block) {
        const size_t first = block * lines.size() / kBlocks, end = (block + 1) * lines.size() / kBlocks;
        if (first < end) crossMesh(repair_, lines, first, end);
    });
    std::vector<std::vector<uint32_t>> about(points.size());
    if (std::any_of(lines.begin(), lines.end(), [](const Line& line) { return line.is_grazed; })) queries();
    tbb::parallel_for(size_t(0), lines.size(), [&](size_t l) {
        const Line& line = lines[l];
        for (size_t i = line.first; i < line.past; ++i)
            about[i] = line.is_grazed ? aboutByRay(points[i]) : line.partsAbout(points[i].x);
    });
    return about;
}

}  // namespace demolish
