// SPDX-License-Identifier: Apache-2.0
// A greedy descent: patches are few, and most junctions are solved by turning one of them.
#include "sim_cuda/authoring/repair/junctions.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "sim_cuda/authoring/repair/edge_uses.h"
#include "sim_cuda/authoring/repair/orientation.h"

namespace demolish {
namespace {

/// How often each patch uses an edge in its direction, less those against it.
struct Share {
    uint32_t patch;
    int sum;
};

class JunctionSolver {
  public:
    explicit JunctionSolver(const RepairMesh& repair)
        : edges_of_(repair.patches),
          free_edges_(repair.patches, 0),
          area_(repair.patches, 0),
          sign_(repair.patches, 1),
          last_sign_(repair.patches, 1) {
        const std::vector<EdgeUse> uses = edgeUses(repair.mesh);
        forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
            if (edge.size() == 1) ++free_edges_[repair.patch[edge[0].triangle]];
            if (edge.size() > 2) addJunction(repair, edge);
        });
        for (size_t t = 0; t < repair.size(); ++t) area_[repair.patch[t]] += repair.area(t);
    }

    size_t edgeCount() const { return junctions_.size(); }

    void turnPatches() {
        constexpr int kRounds = 50;
        bool better = true;
        for (int round = 0; round < kRounds && better; ++round) {
            better = false;
            for (uint32_t p = 0; p < sign_.size(); ++p) {
                if (edges_of_[p].empty()) continue;
                const int before = costAbout(p);
                sign_[p] = -sign_[p];
                if (costAbout(p) < before)
                    better = true;
                else
                    sign_[p] = -sign_[p];
            }
        }
        last_sign_ = sign_;
    }

    /// Small patches first: they are more likely what is too much.
    void takeOutPatches() {
        std::vector<uint32_t> order(sign_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](uint32_t a, uint32_t b) { return area_[a] < area_[b]; });
        for (const uint32_t p : order) {
            const int before = edges_of_[p].empty() ? 0 : costAbout(p);
            if (before == 0) continue;
            sign_[p] = 0;
            if (costAbout(p) + int(edges_of_[p].size()) > before) sign_[p] = last_sign_[p];
        }
    }

    bool isTurned(uint32_t patch) const { return last_sign_[patch] < 0; }
    bool isOut(uint32_t patch) const { return sign_[patch] == 0; }
    bool isFin(uint32_t patch) const { return isOut(patch) && free_edges_[patch] > 0; }
    bool isWall(uint32_t patch) const { return isOut(patch) && free_edges_[patch] == 0; }

  private:
    void addJunction(const RepairMesh& repair, std::span<const EdgeUse> edge) {
        const auto id = uint32_t(junctions_.size());
        auto& shares = junctions_.emplace_back();
        for (const EdgeUse& use : edge) {
            const uint32_t patch = repair.patch[use.triangle];
            auto at = std::find_if(shares.begin(), shares.end(),
                                   [&](const Share& share) { return share.patch == patch; });
            if (at == shares.end()) at = shares.insert(at, {patch, 0});
            at->sum += use.direction;
        }
        std::erase_if(shares, [](const Share& share) { return share.sum == 0; });
        for (const Share& share : shares) edges_of_[share.patch].push_back(id);
    }
    int costAbout(uint32_t patch) const {
        int cost = 0;
        for (const uint32_t edge : edges_of_[patch]) {
            int balance = 0;
            for (const Share& share : junctions_[edge]) balance += sign_[share.patch] * share.sum;
            cost += std::abs(balance);
        }
        return cost;
    }

    std::vector<std::vector<Share>> junctions_;
    std::vector<std::vector<uint32_t>> edges_of_;  // by patch
    std::vector<size_t> free_edges_;
    std::vector<double> area_;
    std::vector<int> sign_, last_sign_;  // -1 turned, 0 taken out
};

}  // namespace

JunctionCounts solveJunctions(RepairMesh& repair) {
    JunctionSolver solver(repair);
    JunctionCounts counts{.edges = solver.edgeCount()};
    if (counts.edges == 0) return counts;
    solver.turnPatches();
    solver.takeOutPatches();
    std::vector<uint32_t> apart(repair.patches, 0);
    for (uint32_t p = 0; p < repair.patches; ++p) {
        counts.turned += solver.isTurned(p) && !solver.isWall(p);
        counts.walls += solver.isWall(p);
        counts.fins += solver.isFin(p);
        if (solver.isFin(p)) apart[p] = p + 1;
    }
    std::vector<char> keep(repair.size());
    for (size_t t = 0; t < repair.size(); ++t) {
        if (solver.isTurned(repair.patch[t])) repair.turn(t);
        keep[t] = !solver.isWall(repair.patch[t]);
    }
    repair.keep(keep);
    numberParts(repair, apart);
    return counts;
}

}  // namespace demolish
