// SPDX-License-Identifier: Apache-2.0
// Builds the triangle tree by binned surface-area splits.
#include "sim_cuda/authoring/triangle_tree.h"

#include <numeric>

namespace demolish {
namespace {

constexpr uint32_t kLeafSize = 4;
constexpr int kBins = 16;
constexpr int kDepthOfHalving =
    40;  // beyond it (bad splits only) halve by number, so that the depth stays bounded

double component(const Double3& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

struct Split {
    int axis = 0, bin = -1;  // bin -1: no split separates the centres
    double lower = 0, scale = 0;
    int binOf(const Double3& centre) const {
        return std::min(kBins - 1, int((component(centre, axis) - lower) * scale));
    }
};

}  // namespace

struct TriangleTree::Builder {
    TriangleTree& tree;
    std::vector<TreeBox> boxes;    // by mesh triangle
    std::vector<Double3> centres;  // by mesh triangle

    Split bestSplit(uint32_t begin, uint32_t end) const {
        TreeBox range;
        for (uint32_t i = begin; i < end; ++i) range.add(centres[tree.triangles_[i]]);
        const Double3 extent = range.upper - range.lower;
        Split best;
        best.axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        best.lower = component(range.lower, best.axis);
        if (!(component(extent, best.axis) > 0)) return best;
        best.scale = kBins / component(extent, best.axis);
        std::array<TreeBox, kBins> bins;
        std::array<uint32_t, kBins> counts{};
        for (uint32_t i = begin; i < end; ++i) {
            const int bin = best.binOf(centres[tree.triangles_[i]]);
            bins[bin].add(boxes[tree.triangles_[i]]);
            ++counts[bin];
        }
        std::array<double, kBins> cost_after{};
        TreeBox box;
        uint32_t count = 0;
        for (int b = kBins - 1; b > 0; --b) {
            box.add(bins[b]);
            cost_after[b] = box.halfArea() * (count += counts[b]);
        }
        double least = std::numeric_limits<double>::infinity();
        box = {};
        count = 0;
        for (int b = 0; b + 1 < kBins; ++b) {
            box.add(bins[b]);
            const double cost = box.halfArea() * (count += counts[b]) + cost_after[b + 1];
            if (count == 0 || count == end - begin || cost >= least) continue;
            least = cost;
            best.bin = b;
        }
        return best;
    }

    void build(uint32_t begin, uint32_t end, int depth) {
        const uint32_t id = uint32_t(tree.nodes_.size());
        tree.nodes_.emplace_back();
        TreeBox box;
        for (uint32_t i = begin; i < end; ++i) box.add(boxes[tree.triangles_[i]]);
        tree.nodes_[id].box = box;
        uint32_t middle = begin + (end - begin) / 2;
        if (end - begin <= kLeafSize) {
            tree.nodes_[id].first = begin;
            tree.nodes_[id].count = end - begin;
            return;
        }
        if (const Split split = bestSplit(begin, end); split.bin >= 0 && depth < kDepthOfHalving) {
            const auto from = tree.triangles_.begin();
            const auto border = std::stable_partition(
                from + begin, from + end, [&](uint32_t t) { return split.binOf(centres[t]) <= split.bin; });
            middle = uint32_t(border - from);
        }
        build(begin, middle, depth + 1);
        tree.nodes_[id].first = uint32_t(tree.nodes_.size());
        build(middle, end, depth + 1);
    }
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) : triangles_(mesh.triangles.size()) {
    std::iota(triangles_.begin(), triangles_.end(), 0u);
    Builder builder{*this, {}, {}};
    TreeBox all;
    for (const Double3& p : mesh.positions) all.add(p);
    // Widened beyond the rounding of the slab test and of the ray's shear.
    const double slack = 1e-12 * (length(all.upper - all.lower) + length(all.upper) + length(all.lower));
    for (const auto& t : mesh.triangles) {
        TreeBox box;
        for (const uint32_t v : t) box.add(mesh.positions[v]);
        builder.centres.push_back((box.lower + box.upper) * 0.5);
        builder.boxes.push_back(
            {box.lower - Double3{slack, slack, slack}, box.upper + Double3{slack, slack, slack}});
    }
    nodes_.reserve(mesh.triangles.size());
    builder.build(0, uint32_t(triangles_.size()), 0);
    corners_.reserve(triangles_.size());
    for (const uint32_t id : triangles_) {
        const auto& t = mesh.triangles[id];
        corners_.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    }
}

}  // namespace demolish
