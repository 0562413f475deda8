// SPDX-License-Identifier: Apache-2.0
// Loops by walking the reversed borders, caps of least area by dynamic programming.
#include "sim_cuda/authoring/repair/holes.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/repair/edge_uses.h"

namespace demolish {
namespace {

constexpr size_t kMostEdges = 600;  // of a cap of least area: its work grows with their third power
constexpr double kMostWork = 6e8;   // of all of them together, some seconds

/// Directed edges of one part's caps, by the vertex that they leave.
using CapEdges = std::map<uint32_t, std::vector<uint32_t>>;

/// Walks until the vertex of the start has no edge left; a vertex that comes again ends a loop.
void walkFrom(uint32_t start, uint32_t part, CapEdges& edges, std::vector<Border>& borders) {
    std::vector<uint32_t> path{start};
    std::unordered_map<uint32_t, size_t> place{{start, 0}};
    for (;;) {
        const auto out = edges.find(path.back());
        if (out == edges.end() || out->second.empty()) return;
        const uint32_t next = out->second.back();
        out->second.pop_back();
        const auto seen = place.find(next);
        if (seen == place.end()) {
            place[next] = path.size();
            path.push_back(next);
            continue;
        }
        const auto begin = path.begin() + std::ptrdiff_t(seen->second);
        if (path.end() - begin > 2) borders.push_back({part, {begin, path.end()}});
        for (auto v = begin + 1; v != path.end(); ++v) place.erase(*v);
        path.erase(begin + 1, path.end());
    }
}

void addLoops(uint32_t part, CapEdges& edges, std::vector<Border>& borders) {
    for (auto& [start, ends] : edges)
        while (!ends.empty()) walkFrom(start, part, edges, borders);
    edges.clear();
}

class Capper {
  public:
    explicit Capper(RepairMesh& repair) : repair_(repair), counts_(repair.parts) {
        for (const Triangle& triangle : repair.mesh.triangles) there_.insert(rotated(triangle));
    }

    void cap(const Border& border) {
        const double edges = double(border.loop.size()), work = edges * edges * edges / 6;
        counts_[border.part].add(border.loop.size());
        if (border.loop.size() <= kMostEdges && work_ + work <= kMostWork) {
            work_ += work;
            capLeastArea(border);
        } else {
            ++counts_[border.part].fans;
            capFan(border);
        }
    }
    const std::vector<HoleCounts>& counts() const { return counts_; }

  private:
    static Triangle rotated(Triangle triangle) {
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        return triangle;
    }

    /// A triangle that is there already would be a double: three about its middle instead.
    void add(const Triangle& vertices, uint32_t part) {
        auto& positions = repair_.mesh.positions;
        const auto [a, b, c] = vertices;
        if (there_.insert(rotated(vertices)).second) {
            repair_.addOwn(vertices, repair_.patches, part);
            return;
        }
        const auto middle = uint32_t(positions.size());
        positions.push_back((positions[a] + positions[b] + positions[c]) * (1.0 / 3));
        for (const Triangle& third : {Triangle{a, b, middle}, {b, c, middle}, {c, a, middle}})
            repair_.addOwn(third, repair_.patches, part);
    }

    void capLeastArea(const Border& border) {
        const auto& loop = border.loop;
        const size_t n = loop.size();
        const auto point = [&](size_t i) -> const Double3& { return repair_.mesh.positions[loop[i]]; };
        std::vector<double> area(n * n, 0);
        std::vector<uint32_t> apex(n * n, 0);  // of the triangle on the chord from i to j
        for (size_t span = 2; span < n; ++span)
            for (size_t i = 0; i + span < n; ++i) {
                const size_t j = i + span;
                const Double3 start = point(i), chord = point(j) - start;
                double best = std::numeric_limits<double>::infinity();
                for (size_t k = i + 1; k < j; ++k) {
                    const double sum =
                        area[i * n + k] + area[k * n + j] + length(cross(point(k) - start, chord));
                    if (sum >= best && k > i + 1) continue;
                    best = sum;
                    apex[i * n + j] = uint32_t(k);
                }
                area[i * n + j] = best;
            }
        std::vector<std::pair<size_t, size_t>> open{{0, n - 1}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (j - i < 2) continue;
            const size_t k = apex[i * n + j];
            add({loop[i], loop[k], loop[j]}, border.part);
            open.push_back({i, k});
            open.push_back({k, j});
        }
    }

    void capFan(const Border& border) {
        auto& positions = repair_.mesh.positions;
        const auto& loop = border.loop;
        Double3 sum;
        double whole = 0;
        for (size_t i = 0; i < loop.size(); ++i) {
            const Double3 a = positions[loop[i]], b = positions[loop[(i + 1) % loop.size()]];
            sum += (a + b) * (length(b - a) / 2);
            whole += length(b - a);
        }
        const auto middle = uint32_t(positions.size());
        positions.push_back(whole > 0 ? sum * (1 / whole) : positions[loop[0]]);
        for (size_t i = 0; i < loop.size(); ++i)
            add({loop[i], loop[(i + 1) % loop.size()], middle}, border.part);
    }

    RepairMesh& repair_;
    std::set<Triangle> there_;
    std::vector<HoleCounts> counts_;
    double work_ = 0;
};

}  // namespace

std::vector<Border> borderLoops(const RepairMesh& repair) {
    std::vector<Border> borders;
    CapEdges edges;
    uint32_t part = 0;
    const std::vector<EdgeUse> uses = edgeUses(repair.mesh, repair.part);
    forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
        if (edge[0].group != part) {
            addLoops(part, edges, borders);
            part = edge[0].group;
        }
        const int balance = imbalanceOf(edge);
        for (int i = 0; i < balance; ++i) edges[edge[0].high].push_back(edge[0].low);
        for (int i = 0; i < -balance; ++i) edges[edge[0].low].push_back(edge[0].high);
    });
    addLoops(part, edges, borders);
    return borders;
}

std::vector<HoleCounts> fillHoles(RepairMesh& repair) {
    const std::vector<Border> borders = borderLoops(repair);
    if (borders.empty()) return std::vector<HoleCounts>(repair.parts);
    Capper capper(repair);
    for (const Border& border : borders) capper.cap(border);
    ++repair.patches;
    return capper.counts();
}

}  // namespace demolish
