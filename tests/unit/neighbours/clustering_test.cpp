// SPDX-License-Identifier: Apache-2.0
// Clustering on cuts whose fragments are known (physics D 24), against a plain search, for any number of
// threads.
#include "sim_cuda/solver/clustering.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <map>
#include <numeric>
#include <random>

#include "sim_cuda/backend/cpu_backend.h"
#include "tests/unit/neighbours/bonded_grid.h"

namespace demolish {
namespace {
using test::BondedGrid;

std::map<uint32_t, uint32_t> sizesOf(const std::vector<uint32_t>& label) {
    std::map<uint32_t, uint32_t> sizes;
    for (const uint32_t l : label) ++sizes[l];
    return sizes;
}

/// Lowest id reachable over intact bonds, by a flood from every particle in turn.
std::vector<uint32_t> floodLabels(const BondedGrid& grid) {
    std::vector<uint32_t> label(grid.count(), ~0u), open;
    for (uint32_t start = 0; start < grid.count(); ++start) {
        if (label[start] != ~0u) continue;
        open.assign(1, start);
        label[start] = start;
        while (!open.empty()) {
            const uint32_t i = open.back();
            open.pop_back();
            for (uint32_t s = grid.row_start[i]; s < grid.row_start[i + 1]; ++s) {
                const uint32_t j = linkedParticle(grid.link[s]);
                if (!isBonded(grid.link[s]) || label[j] != ~0u) continue;
                label[j] = start;
                open.push_back(j);
            }
        }
    }
    return label;
}

struct Result {
    std::vector<uint32_t> label, order, first, size;
};
Result cluster(const BondedGrid& grid) {
    CpuBackend backend;
    const auto rows = backend.uploaded(grid.row_start);
    const auto links = backend.uploaded(grid.link);
    Clustering<CpuBackend> clustering(backend, {grid.count(), grid.count() + kMaxProjectiles});
    clustering.update(rows.view(), links.view());
    const FragmentRows out = clustering.rows();
    return {backend.downloaded(out.fragment), backend.downloaded(out.order), backend.downloaded(out.first),
            backend.downloaded(out.size)};
}

TEST(Clustering, AnUncutBlockIsOneFragmentAndACutMakesTwo) {  // D 24
    BondedGrid grid(12, 5, 4);
    EXPECT_EQ(sizesOf(cluster(grid).label), (std::map<uint32_t, uint32_t>{{0, 240}}));
    grid.cut([](const BondedGrid::Place& a, const BondedGrid::Place& b) { return (a.x < 5) != (b.x < 5); });
    EXPECT_EQ(sizesOf(cluster(grid).label), (std::map<uint32_t, uint32_t>{{0, 100}, {5, 140}}));
    grid.cut([](const BondedGrid::Place& a, const BondedGrid::Place& b) { return a.z != b.z && a.x >= 5; });
    EXPECT_EQ(sizesOf(cluster(grid).label),
              (std::map<uint32_t, uint32_t>{{0, 100}, {5, 35}, {65, 35}, {125, 35}, {185, 35}}));
}

TEST(Clustering, BrokenAndRetiredBondsDoNotHold) {
    BondedGrid grid(3, 1, 1);
    for (const PairState state : {PairState::kBroken, PairState::kContact}) {
        grid.setState(0, 1, state);
        EXPECT_EQ(cluster(grid).label, (std::vector<uint32_t>{0, 1, 1}));
    }
}

TEST(Clustering, OneBondIsEnoughAndAllBondsGoneIsDust) {
    BondedGrid grid(6, 6, 6);
    grid.cut([](const BondedGrid::Place& a, const BondedGrid::Place& b) {
        return (a.x < 3) != (b.x < 3) && !(a.y == 5 && a.z == 5);
    });
    EXPECT_EQ(sizesOf(cluster(grid).label).size(), 1u);
    grid.cut([](const BondedGrid::Place&, const BondedGrid::Place&) { return true; });
    std::vector<uint32_t> own(grid.count());
    std::iota(own.begin(), own.end(), 0u);
    EXPECT_EQ(cluster(grid).label, own);
}

TEST(Clustering, AgreesWithAFloodOnRandomDamageForOneAndTwoThreads) {
    std::mt19937 random(3);
    for (const double share : {0.3, 0.6, 0.75, 0.9}) {
        BondedGrid grid(20, 20, 15);
        std::uniform_real_distribution<double> uniform;
        grid.cut([&](const BondedGrid::Place&, const BondedGrid::Place&) { return uniform(random) < share; });
        const auto expected = floodLabels(grid);
        for (const size_t threads : {1u, 2u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            EXPECT_EQ(cluster(grid).label, expected) << share;
        }
    }
}

TEST(Clustering, ThreadsThatShareAParticleJoinTheSame) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    BondedGrid grid(20, 20, 15);
    grid.cut([&](const BondedGrid::Place&, const BondedGrid::Place&) { return uniform(random) < 0.7; });
    CpuBackend backend;
    const auto rows = backend.uploaded(grid.row_start);
    const auto links = backend.uploaded(grid.link);
    auto label = backend.allocate<uint32_t>(grid.count());
    backend.forEach(grid.count(), StartLabels{rows.view(), links.view(), label.span(), grid.count()},
                    "start");
    backend.forEach(size_t{grid.count()} * 4, JoinBonded<4>{rows.view(), links.view(), label.span()}, "join");
    backend.forEach(grid.count(), FlattenLabels{label.span()}, "flatten");
    EXPECT_EQ(backend.downloaded(label.view()), floodLabels(grid));
}

TEST(Clustering, LongChainsInAwkwardOrder) {
    // A snake whose links join far ids: 0 - n-1 - 1 - n-2 - 2 ...
    const uint32_t n = 5001;
    std::vector<uint32_t> snake;
    for (uint32_t k = 0; k < n; ++k) snake.push_back(k % 2 == 0 ? k / 2 : n - 1 - k / 2);
    BondedGrid grid = test::chainThrough(snake);
    EXPECT_EQ(sizesOf(cluster(grid).label), (std::map<uint32_t, uint32_t>{{0, n}}));
}

TEST(Clustering, OrdersParticlesByFragmentAndId) {
    BondedGrid grid(17, 13, 11);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    grid.cut([&](const BondedGrid::Place&, const BondedGrid::Place&) { return uniform(random) < 0.7; });
    const Result result = cluster(grid);
    std::vector<uint32_t> expected(grid.count());
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(),
                     [&](uint32_t a, uint32_t b) { return result.label[a] < result.label[b]; });
    EXPECT_EQ(result.order, expected);
    for (const auto& [slot, size] : sizesOf(result.label)) {
        EXPECT_EQ(result.size[slot], size);
        EXPECT_EQ(result.order[result.first[slot]], slot);
    }
}

}  // namespace
}  // namespace demolish
