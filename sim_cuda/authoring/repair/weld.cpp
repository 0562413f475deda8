// SPDX-License-Identifier: Apache-2.0
// Vertices that stayed lie in a hash grid of cells four tolerances wide.
#include "sim_cuda/authoring/repair/weld.h"

#include <cmath>
#include <unordered_map>

#include "sim_cuda/authoring/bounds.h"

namespace demolish {
namespace {

using Cell = std::array<int64_t, 3>;
struct CellHash {
    size_t operator()(const Cell& cell) const {
        uint64_t h = 0;
        for (const int64_t index : cell) h = (h ^ (h >> 29) ^ uint64_t(index)) * 0x9e3779b97f4a7c15ull;
        return size_t(h ^ (h >> 32));
    }
};

class StayingVertices {
  public:
    StayingVertices(const Double3& origin, double tolerance, size_t most)
        : origin_(origin), tolerance_(tolerance), per_metre_(1 / (4 * tolerance)) {
        first_.reserve(most);
    }

    /// The nearest that stayed within the tolerance, or the point itself as a new one.
    uint32_t idOf(const Double3& p) {
        uint32_t best = kNone;
        double best_squared = tolerance_ * tolerance_;
        const Cell low = cellOf(p - Double3{tolerance_, tolerance_, tolerance_}),
                   high = cellOf(p + Double3{tolerance_, tolerance_, tolerance_});
        for (int64_t z = low[2]; z <= high[2]; ++z)
            for (int64_t y = low[1]; y <= high[1]; ++y)
                for (int64_t x = low[0]; x <= high[0]; ++x) lookIn({x, y, z}, p, best, best_squared);
        return best != kNone ? best : add(p);
    }
    std::vector<Double3> take() && { return std::move(positions_); }

  private:
    static constexpr uint32_t kNone = 0xffffffffu;

    Cell cellOf(const Double3& p) const {
        const Double3 q = (p - origin_) * per_metre_;
        return {int64_t(std::floor(q.x)), int64_t(std::floor(q.y)), int64_t(std::floor(q.z))};
    }
    void lookIn(const Cell& cell, const Double3& p, uint32_t& best, double& best_squared) const {
        const auto found = first_.find(cell);
        if (found == first_.end()) return;
        for (uint32_t v = found->second; v != kNone; v = next_[v]) {
            const double squared = lengthSquared(positions_[v] - p);
            if (squared > best_squared || (squared == best_squared && v > best)) continue;
            best_squared = squared;
            best = v;
        }
    }
    uint32_t add(const Double3& p) {
        const auto id = uint32_t(positions_.size());
        const auto [place, is_new] = first_.try_emplace(cellOf(p), id);
        next_.push_back(is_new ? kNone : place->second);
        place->second = id;
        positions_.push_back(p);
        return id;
    }

    Double3 origin_;
    double tolerance_, per_metre_;
    std::vector<Double3> positions_;
    std::vector<uint32_t> next_;  // of the same cell
    std::unordered_map<Cell, uint32_t, CellHash> first_;
};

}  // namespace

size_t weldNear(RepairMesh& repair, double tolerance) {
    TriangleMesh& mesh = repair.mesh;
    if (mesh.positions.empty() || !(tolerance > 0)) return 0;
    StayingVertices staying(boundsOf(mesh.positions).lower, tolerance, mesh.positions.size());
    std::vector<uint32_t> id(mesh.positions.size());
    for (size_t v = 0; v < id.size(); ++v) id[v] = staying.idOf(mesh.positions[v]);
    mesh.positions = std::move(staying).take();
    std::vector<char> keep(repair.size());
    for (size_t t = 0; t < repair.size(); ++t) {
        Triangle& triangle = mesh.triangles[t];
        for (uint32_t& v : triangle) v = id[v];
        keep[t] = triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0];
    }
    repair.keep(keep);
    return id.size() - mesh.positions.size();
}

}  // namespace demolish
