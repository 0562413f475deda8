// SPDX-License-Identifier: Apache-2.0
// Builds the triangle tree by binned surface-area splits, two to a node.
#include "sim_cuda/authoring/triangle_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

namespace demolish {
namespace {

constexpr uint32_t kLeafSize = 4;
constexpr int kBins = 16;
constexpr uint32_t kAtOnce = 1 << 15;  // pieces from which on both halves are built at the same time
constexpr int kDepthOfHalving =
    40;  // beyond it (bad splits only) halve by number, so that the depth stays bounded

template <typename Visit>
void forEachInBlocks(size_t count, Visit&& visit) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 4096), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) visit(i);
    });
}

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

bool isMostlyEmpty(const Piece& piece, double least) {
    constexpr double kMostlyEmpty = 8;  // box over triangle, by area
    const double half_area = piece.box().halfArea();
    return half_area > least && half_area > kMostlyEmpty * piece.area();
}

/// Calls emit(piece) for the parts of a piece whose boxes are mostly empty no more, or not above `least`
/// (m^2) by half of their area.
template <typename Emit>
void halve(const Piece& piece, double least, Emit&& emit) {
    if (!isMostlyEmpty(piece, least)) {
        emit(piece);
        return;
    }
    for (const Piece& half : piece.halves()) halve(half, least, emit);
}

/// The triangles, in blocks, each as the pieces that halve() makes of it.
class HalvedTriangles {
  public:
    explicit HalvedTriangles(const TriangleMesh& mesh)
        : mesh_(mesh), counts_((mesh.triangles.size() + kBlock - 1) / kBlock) {}

    size_t count(double least) {
        tbb::parallel_for(size_t(0), counts_.size(), [&](size_t block) {
            counts_[block] = 0;
            halveBlock(block, least, [&](const Piece&) { ++counts_[block]; });
        });
        return std::accumulate(counts_.begin(), counts_.end(), size_t(0));
    }
    std::vector<Piece> pieces(double least) {
        std::vector<Piece> all(count(least));
        std::exclusive_scan(counts_.begin(), counts_.end(), counts_.begin(), size_t(0));
        tbb::parallel_for(size_t(0), counts_.size(), [&](size_t block) {
            halveBlock(block, least, [&](const Piece& piece) { all[counts_[block]++] = piece; });
        });
        return all;
    }

  private:
    static constexpr size_t kBlock = 1024;

    template <typename Emit>
    void halveBlock(size_t block, double least, Emit&& emit) const {
        const size_t end = std::min((block + 1) * kBlock, mesh_.triangles.size());
        for (size_t t = block * kBlock; t < end; ++t) {
            const auto& k = mesh_.triangles[t];
            halve({{mesh_.positions[k[0]], mesh_.positions[k[1]], mesh_.positions[k[2]]}, uint32_t(t)}, least,
                  emit);
        }
    }

    const TriangleMesh& mesh_;
    std::vector<size_t> counts_;  // by block
};

/// All triangles in order. Slender ones askew in large boxes, where a query would meet many of them to no
/// purpose, are halved: as finely as leaves no more pieces than are worth it.
std::vector<Piece> piecesOf(const TriangleMesh& mesh) {
    constexpr double kFiner = 0.7;                      // from one try to the next
    constexpr double kLarge = 1.0 / 1024;               // of the mesh's box, by area:
    constexpr size_t kMostOfLarge = 4;                  // pieces, by triangle of the mesh
    constexpr double kSmall = 1.0 / 16384;              // in meshes that are not large themselves also these,
    constexpr size_t kMost = 16, kMostInAll = 500'000;  // up to so many
    TreeBox all;
    for (const auto& t : mesh.triangles)
        for (const uint32_t v : t) all.add(mesh.positions[v]);
    const size_t triangles = mesh.triangles.size(), most = std::min(kMost * triangles, kMostInAll),
                 most_of_large = std::max(kMostOfLarge * triangles, most);
    const double large = kLarge * all.halfArea(),
                 finest = (triangles < most ? kSmall : kLarge) * all.halfArea();
    HalvedTriangles halved(mesh);
    double least = all.halfArea();
    for (double finer = kFiner * least; finer >= finest && finer > 0 && finer < kEndless; finer *= kFiner) {
        if (halved.count(finer) > (finer >= large ? most_of_large : most)) break;
        least = finer;
    }
    return halved.pieces(least);
}

struct Split {
    int axis = 0, bin = -1;  // bin -1: no split separates the centres
    double lower = 0, scale = 0;
    int binOf(const Double3& centre) const {
        return std::min(kBins - 1, int((component(centre, axis) - lower) * scale));
    }
};

/// A node of the tree with two children, or a leaf.
struct Half {
    TreeBox box;
    uint32_t first = 0;  ///< leaf: first of its triangles; else its second child (the first is the next one)
    uint32_t count = 0;  ///< of triangles; 0: no leaf
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

    /// Where the range is parted into two; its order is settled by then.
    uint32_t parted(uint32_t begin, uint32_t end, int depth) const {
        const Split split = bestSplit(begin, end);
        if (split.bin < 0 || depth >= kDepthOfHalving) return begin + (end - begin) / 2;
        const auto from = tree.triangles_.begin();
        const auto border = std::stable_partition(
            from + begin, from + end, [&](uint32_t t) { return split.binOf(centres[t]) <= split.bin; });
        return uint32_t(border - from);
    }

    /// Appends the tree of the range. Large halves are built at the same time and strung together.
    void build(uint32_t begin, uint32_t end, int depth, std::vector<Half>& halves) const {
        const size_t id = halves.size();
        halves.emplace_back();
        for (uint32_t i = begin; i < end; ++i) halves[id].box.add(boxes[tree.triangles_[i]]);
        if (end - begin <= kLeafSize) {
            halves[id].first = begin;
            halves[id].count = end - begin;
            return;
        }
        const uint32_t middle = parted(begin, end, depth);
        if (end - begin < kAtOnce) {
            build(begin, middle, depth + 1, halves);
            halves[id].first = uint32_t(halves.size());
            build(middle, end, depth + 1, halves);
            return;
        }
        std::vector<Half> low, high;
        tbb::parallel_invoke([&] { build(begin, middle, depth + 1, low); },
                             [&] { build(middle, end, depth + 1, high); });
        append(low, halves);
        halves[id].first = uint32_t(halves.size());
        append(high, halves);
    }

    static void append(const std::vector<Half>& subtree, std::vector<Half>& halves) {
        const auto before = uint32_t(halves.size());
        for (const Half& half : subtree) {
            halves.push_back(half);
            if (half.count == 0) halves.back().first += before;
        }
    }

    /// The leaves and trees two steps below halves[id], or one where a leaf is; the leaf itself if that is
    /// one.
    static std::vector<size_t> belowOf(const std::vector<Half>& halves, size_t id) {
        std::vector<size_t> below;
        const auto add = [&](size_t half) { below.push_back(half); };
        const auto addHalves = [&](size_t half, const auto& addHalf) {
            if (halves[half].count > 0) return add(half);
            addHalf(half + 1);
            addHalf(halves[half].first);
        };
        addHalves(id, [&](size_t half) { addHalves(half, add); });
        return below;
    }

    /// The node of what is below halves[id]; returns its number.
    uint32_t addNode(const std::vector<Half>& halves, size_t id) {
        const std::vector<size_t> below = belowOf(halves, id);
        const size_t number = tree.nodes_.size();
        tree.nodes_.emplace_back();
        tree.nodes_[number].size = int(below.size());
        for (size_t lane = 0; lane < below.size(); ++lane) {
            const Half& half = halves[below[lane]];
            const bool is_leaf = half.count > 0;
            const Child child{is_leaf ? half.first : addNode(halves, below[lane]), half.count};
            tree.nodes_[number].boxes.set(int(lane), half.box);
            tree.nodes_[number].children[lane] = child;
        }
        return uint32_t(number);
    }
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) : triangle_count_(mesh.triangles.size()) {
    if (mesh.triangles.empty()) {
        nodes_.emplace_back();
        return;
    }
    const std::vector<Piece> pieces = piecesOf(mesh);
    triangles_.resize(pieces.size());
    std::iota(triangles_.begin(), triangles_.end(), 0u);
    Builder builder{*this, {}, {}};
    TreeBox all;
    for (const Double3& p : mesh.positions) all.add(p);
    // Widened beyond the rounding of the slab test, of the ray's shear and of halved sides.
    const double slack = 1e-12 * (length(all.upper - all.lower) + length(all.upper) + length(all.lower));
    builder.centres.resize(pieces.size());
    builder.boxes.resize(pieces.size());
    forEachInBlocks(pieces.size(), [&](size_t i) {
        const TreeBox box = pieces[i].box();
        builder.centres[i] = (box.lower + box.upper) * 0.5;
        builder.boxes[i] = {box.lower - Double3{slack, slack, slack},
                            box.upper + Double3{slack, slack, slack}};
    });
    std::vector<Half> halves;
    builder.build(0, uint32_t(triangles_.size()), 0, halves);
    bounds_ = halves[0].box;
    nodes_.reserve(halves.size() / 3 + 1);
    builder.addNode(halves, 0);
    corners_.resize(triangles_.size());
    forEachInBlocks(triangles_.size(), [&](size_t i) {
        triangles_[i] = pieces[triangles_[i]].triangle;
        const auto& t = mesh.triangles[triangles_[i]];
        corners_[i] = {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
    });
}

}  // namespace demolish
