// SPDX-License-Identifier: Apache-2.0
// Laplacian smoothing held to the field.
#include "assets/models/relax.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace demolish::sculptor {
namespace {

/// Neighbours of all vertices in one list, `starts[v]` to `starts[v + 1]`, rising.
struct Neighbours {
    std::vector<std::uint32_t> starts, list;
};

Neighbours neighboursOf(const Surface& surface) {
    std::vector<std::uint64_t> pairs;
    for (const Triangle& t : surface.triangles)
        for (int i = 0; i < 3; ++i) pairs.push_back(std::uint64_t{t[i]} << 32 | t[(i + 1) % 3]);
    std::sort(pairs.begin(), pairs.end());
    Neighbours neighbours;
    neighbours.starts.assign(surface.positions.size() + 1, 0);
    for (const std::uint64_t pair : pairs) {
        ++neighbours.starts[(pair >> 32) + 1];
        neighbours.list.push_back(static_cast<std::uint32_t>(pair));
    }
    for (std::size_t v = 0; v < surface.positions.size(); ++v)
        neighbours.starts[v + 1] += neighbours.starts[v];
    return neighbours;
}

Vec3 newtonStep(const Field& field, Vec3 p, double cell) {
    const Vec3 gradient = field.gradient(p, 0.05 * cell);
    const double squared = dot(gradient, gradient);
    if (squared < 1e-6) return p;  // a ridge line of the field: no direction to go in
    const Vec3 step = (field.at(p) / squared) * gradient;
    const double l = length(step);
    return p - (l > cell ? cell / l : 1.0) * step;
}

}  // namespace

void relax(Surface& surface, const Field& field, double cell, int passes) {
    const Neighbours neighbours = neighboursOf(surface);
    std::vector<Vec3> moved(surface.positions.size());
    for (int pass = 0; pass < passes; ++pass) {
        tbb::parallel_for(std::size_t{0}, moved.size(), [&](std::size_t v) {
            Vec3 sum;
            const auto first = neighbours.starts[v], last = neighbours.starts[v + 1];
            for (auto i = first; i < last; ++i) sum = sum + surface.positions[neighbours.list[i]];
            const Vec3 old = surface.positions[v];
            Vec3 p = old + 0.6 * ((1.0 / (last - first)) * sum - old);
            for (int step = 0; step < 2; ++step) p = newtonStep(field, p, cell);
            moved[v] = p;
        });
        surface.positions.swap(moved);
    }
}

}  // namespace demolish::sculptor
