// SPDX-License-Identifier: Apache-2.0
// Builds the triangle tree by binned surface-area splits.
#include "sim_cuda/authoring/triangle_tree.h"

#include <algorithm>
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

/// A triangle or a part of one, as the tree sorts it.
struct Piece {
    TriangleTree::Corners corners;
    uint32_t triangle;
    TreeBox box() const {
        TreeBox box;
        for (const Double3& p : corners) box.add(p);
        return box;
    }
    /// m^2
    double area() const { return length(cross(corners[1] - corners[0], corners[2] - corners[0])) / 2; }
    /// Halved across its longest side.
    std::array<Piece, 2> halves() const {
        size_t longest = 0;
        const auto side = [&](size_t k) { return lengthSquared(corners[(k + 1) % 3] - corners[k]); };
        for (size_t k = 1; k < 3; ++k)
            if (side(k) > side(longest)) longest = k;
        const Double3 &a = corners[longest], &b = corners[(longest + 1) % 3], &c = corners[(longest + 2) % 3];
        const Double3 middle = (a + b) * 0.5;
        return {{{{a, middle, c}, triangle}, {{middle, b, c}, triangle}}};
    }
};

/// All triangles in order, then what those leave that are halved: slender ones askew in large boxes, the
/// largest first, where a query would meet many of them to no purpose.
std::vector<Piece> piecesOf(const TriangleMesh& mesh) {
    constexpr double kLarge = 1.0 / 1024;  // of the mesh's box, by area
    constexpr double kMostlyEmpty = 8;     // box over triangle, by area
    constexpr size_t kMostPieces = 4;      // by triangle of the mesh
    std::vector<Piece> pieces;
    pieces.reserve(mesh.triangles.size());
    TreeBox all;
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& k = mesh.triangles[t];
        pieces.push_back({{mesh.positions[k[0]], mesh.positions[k[1]], mesh.positions[k[2]]}, t});
        all.add(pieces.back().box());
    }
    const double large = kLarge * all.halfArea();
    std::vector<std::pair<double, uint32_t>> heap;  // area of the box, piece
    const auto consider = [&](uint32_t piece) {
        const double half_area = pieces[piece].box().halfArea();
        if (half_area > large && half_area > kMostlyEmpty * pieces[piece].area())
            heap.emplace_back(half_area, piece);
    };
    for (uint32_t piece = 0; piece < pieces.size(); ++piece) consider(piece);
    std::make_heap(heap.begin(), heap.end());
    while (!heap.empty() && pieces.size() < kMostPieces * mesh.triangles.size()) {
        const uint32_t piece = heap.front().second;
        std::pop_heap(heap.begin(), heap.end());
        heap.pop_back();
        const auto halves = pieces[piece].halves();
        pieces[piece] = halves[0];
        pieces.push_back(halves[1]);
        for (const uint32_t half : {piece, uint32_t(pieces.size() - 1)}) {
            const size_t before = heap.size();
            consider(half);
            if (heap.size() > before) std::push_heap(heap.begin(), heap.end());
        }
    }
    return pieces;
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
    std::vector<TreeBox> boxes;    // by piece
    std::vector<Double3> centres;  // by piece

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

TriangleTree::TriangleTree(const TriangleMesh& mesh) : triangle_count_(mesh.triangles.size()) {
    const std::vector<Piece> pieces = piecesOf(mesh);
    triangles_.resize(pieces.size());
    std::iota(triangles_.begin(), triangles_.end(), 0u);
    Builder builder{*this, {}, {}};
    TreeBox all;
    for (const Double3& p : mesh.positions) all.add(p);
    // Widened beyond the rounding of the slab test, of the ray's shear and of halved sides.
    const double slack = 1e-12 * (length(all.upper - all.lower) + length(all.upper) + length(all.lower));
    for (const Piece& piece : pieces) {
        const TreeBox box = piece.box();
        builder.centres.push_back((box.lower + box.upper) * 0.5);
        builder.boxes.push_back(
            {box.lower - Double3{slack, slack, slack}, box.upper + Double3{slack, slack, slack}});
    }
    nodes_.reserve(pieces.size());
    builder.build(0, uint32_t(triangles_.size()), 0);
    corners_.reserve(triangles_.size());
    for (uint32_t& id : triangles_) {
        id = pieces[id].triangle;
        const auto& t = mesh.triangles[id];
        corners_.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
    }
}

}  // namespace demolish
