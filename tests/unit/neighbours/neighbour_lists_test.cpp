// SPDX-License-Identifier: Apache-2.0
// Contact lists against brute force: the same pairs, sorted, at both ends, for any number of threads.
#include "sim_cuda/solver/neighbour_lists.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include "tests/unit/neighbours/particle_cloud.h"

namespace demolish {
namespace {
using test::Cloud;
using test::CloudArrays;
using Lists = NeighbourLists<CpuBackend, float>;

std::vector<std::vector<uint32_t>> rowsOf(const Lists& lists) {
    const auto in = lists.contacts().in();
    std::vector<std::vector<uint32_t>> rows;
    for (size_t i = 0; i + 1 < in.row_start.size(); ++i)
        rows.emplace_back(&in.neighbour[in.row_start[i]],
                          &in.neighbour[in.row_start[i]] + in.row_start[i + 1] - in.row_start[i]);
    return rows;
}

/// Pairs by the same rule, without a grid.
std::vector<std::vector<uint32_t>> bruteForce(const Cloud& cloud, const Lists& lists) {
    const auto paths = lists.contacts().paths();
    const auto n = static_cast<uint32_t>(cloud.items.size());
    std::vector<std::vector<uint32_t>> rows(n);
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t j = 0; j < n; ++j) {
            if (i == j || !cloud.items[i].active || !cloud.items[j].active || cloud.bonded(i, j)) continue;
            if (mayMeet(paths.position[i], paths.velocity[i], paths.position[j], paths.velocity[j],
                        static_cast<float>(lists.horizon())))
                rows[i].push_back(j);
        }
    return rows;
}

std::vector<std::vector<uint32_t>> expectBruteForce(const Cloud& cloud) {
    CloudArrays arrays(cloud);
    Lists lists(arrays.backend, cloud.counts(), cloud.largestRadius());
    lists.build(arrays.state(), arrays.particles.constants.view(), arrays.bonds.in());
    const auto rows = rowsOf(lists), expected = bruteForce(cloud, lists);
    EXPECT_EQ(rows, expected);
    return rows;
}
size_t total(const std::vector<std::vector<uint32_t>>& rows) {
    size_t sum = 0;
    for (const auto& row : rows) sum += row.size();
    return sum;
}

TEST(NeighbourLists, FindExactlyThePairsOfBruteForceAtRest) {
    const auto rows = expectBruteForce(test::randomCloud(1500, 0.5, 0.01, 0.02, 0, 1));
    EXPECT_GT(total(rows), 2000u);
}

TEST(NeighbourLists, NewPairsGoToTheirPlacesAndTheOthersKeepTheirSprings) {
    const Cloud cloud = test::randomCloud(300, 0.4, 0.01, 0.02, 0, 5);
    CloudArrays arrays(cloud);
    Lists lists(arrays.backend, cloud.counts(), cloud.largestRadius());
    lists.build(arrays.state(), arrays.particles.constants.view(), arrays.bonds.in());
    auto expected = rowsOf(lists);
    const auto springOf = [](uint32_t i, uint32_t j) { return float(1000 * i + j); };
    auto& contacts = lists.contacts();
    for (uint32_t i = 0, slot = 0; i < expected.size(); ++i)
        for (const uint32_t j : expected[i]) contacts.spring.span()[slot++].x = springOf(i, j);
    std::vector<uint64_t> entries;
    std::set<std::pair<uint32_t, uint32_t>> added;
    for (uint32_t k = 0; entries.size() < 200; ++k) {
        // Two rows in the middle get many, and so do the first and the last (a projectile's).
        const uint32_t i = k % 3 == 0   ? 150
                           : k % 3 == 1 ? 0
                                        : cloud.counts().total - 1,
                       j = (k * 97) % 299 + 1;
        const auto& row = expected[i];
        if (i == j || std::binary_search(row.begin(), row.end(), j)) continue;
        for (const auto& [a, b] : {std::pair{i, j}, std::pair{j, i}})
            if (added.insert({a, b}).second) entries.push_back(rowEntry(a, b));
    }
    for (const auto& [i, j] : added) expected[i].push_back(j);
    for (auto& row : expected) std::sort(row.begin(), row.end());
    lists.insert(arrays.backend.uploaded(entries).view());
    EXPECT_EQ(rowsOf(lists), expected);
    EXPECT_EQ(lists.contacts().used, total(expected));
    for (uint32_t i = 0, slot = 0; i < expected.size(); ++i)
        for (const uint32_t j : expected[i])
            ASSERT_EQ(lists.contacts().spring.view()[slot++].x, added.count({i, j}) ? 0 : springOf(i, j));
}

TEST(NeighbourLists, FindExactlyThePairsOfBruteForceInMotion) {
    EXPECT_GT(total(expectBruteForce(test::randomCloud(1500, 0.5, 0.01, 0.02, 8, 2))), 2000u);
}

TEST(NeighbourLists, AFewFastOnesDoNotShortenTheHorizonAndMissNobody) {
    const Cloud cloud = test::randomCloud(3000, 0.5, 0.01, 0.02, 0.5, 7);
    const auto horizonOf = [](const Cloud& of) {
        CloudArrays arrays(of);
        Lists lists(arrays.backend, of.counts(), of.largestRadius());
        lists.build(arrays.state(), arrays.particles.constants.view(), arrays.bonds.in());
        EXPECT_EQ(rowsOf(lists), bruteForce(of, lists));
        return lists.horizon();
    };
    const double all_slow = horizonOf(cloud);
    const auto withEvery = [&](uint32_t nth) {
        Cloud thrown = cloud;
        for (uint32_t k = 0; k * nth < thrown.items.size(); ++k)
            thrown.items[k * nth].v = {k % 2 == 0 ? 20.0f : -20.0f, 0, k % 3 == 0 ? 15.0f : 0.0f};
        return horizonOf(thrown);
    };
    const double many_fast = withEvery(2);
    EXPECT_LT(many_fast, 0.1 * all_slow);
    EXPECT_GT(withEvery(211), 3 * many_fast);
}

TEST(NeighbourLists, RowsOfTheFastMayBeLongerThanTheirDrafts) {
    Cloud cloud = test::randomCloud(2500, 0.12, 0.01, 0.02, 0.2, 8);
    for (uint32_t k = 0; k < 12; ++k) cloud.items[200 * k].v = {15, 3, 0};
    const auto rows = expectBruteForce(cloud);
    EXPECT_GT(rows[0].size(), 256u);
}

TEST(NeighbourLists, MorePerCellThanThePapersFour) {
    const auto rows = expectBruteForce(test::randomCloud(300, 0.01, 0.01, 0.02, 0, 3));
    EXPECT_EQ(total(rows), 300u * 299u);  // all touch all
}

TEST(NeighbourLists, HugeAndSmallRadiiTogether) {
    Cloud cloud = test::randomCloud(800, 1.0, 0.001, 0.01, 2, 4);
    cloud.items[17].radius = 0.3f;
    cloud.items[400].radius = 0.2f;
    const auto rows = expectBruteForce(cloud);
    EXPECT_GT(rows[17].size(), 50u);
}

TEST(NeighbourLists, FarFromTheOriginAndFarApart) {
    Cloud cloud = test::randomCloud(600, 0.3, 0.01, 0.02, 3, 5);
    for (uint32_t i = 0; i < 300; ++i) cloud.items[i].x = cloud.items[i].x + Vec3<float>{700, -300, 20};
    expectBruteForce(cloud);
}

TEST(NeighbourLists, LeaveOutPairsWithABondRecord) {
    Cloud cloud = test::randomCloud(400, 0.2, 0.01, 0.02, 0, 6);
    const auto before = expectBruteForce(cloud);
    for (uint32_t i = 0; i < cloud.in_bodies; ++i)
        for (const uint32_t j : before[i])
            if (i < j && (i + j) % 3 == 0) cloud.bonds.insert({i, j});
    ASSERT_GT(cloud.bonds.size(), 50u);
    EXPECT_EQ(total(expectBruteForce(cloud)) + 2 * cloud.bonds.size(), total(before));
}

TEST(NeighbourLists, ProjectilesHaveLongRowsAndStandLastInOthers) {
    Cloud cloud = test::randomCloud(3000, 0.4, 0.008, 0.012, 1, 7);
    cloud.items[cloud.in_bodies + 2] = {{0, 0, 0.1f}, {0, 0, -15}, 0.1f, true};
    cloud.items[cloud.in_bodies + 5] = {{0.05f, 0.1f, 0.1f}, {3, 0, 0}, 0.05f, true};
    const auto rows = expectBruteForce(cloud);
    EXPECT_GT(rows[cloud.in_bodies + 2].size(), 256u);
    EXPECT_EQ(rows[cloud.in_bodies + 2].back(), cloud.in_bodies + 5);
    EXPECT_TRUE(rows[cloud.in_bodies].empty());  // an unused slot
    size_t seen = 0;
    for (uint32_t i = 0; i < cloud.in_bodies; ++i)
        seen += std::count(rows[i].begin(), rows[i].end(), cloud.in_bodies + 2);
    EXPECT_EQ(seen + 1, rows[cloud.in_bodies + 2].size());
}

TEST(NeighbourLists, OneParticleAndNoNeighbours) {
    EXPECT_EQ(total(expectBruteForce(test::randomCloud(1, 1, 0.01, 0.02, 1, 8))), 0u);
}

TEST(NeighbourLists, AreTheSameForOneThreadAndTwo) {
    Cloud cloud = test::randomCloud(2000, 0.3, 0.01, 0.02, 5, 9);
    cloud.items[cloud.in_bodies] = {{}, {4, 0, 0}, 0.1f, true};
    std::vector<std::vector<std::vector<uint32_t>>> results;
    for (const size_t threads : {1u, 2u, 2u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        results.push_back(expectBruteForce(cloud));
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(results[0], results[2]);
}

TEST(NeighbourLists, CarrySpringsOverById) {
    Cloud cloud = test::randomCloud(800, 0.25, 0.01, 0.02, 2, 10);
    cloud.items[cloud.in_bodies] = {{}, {}, 0.1f, true};
    CloudArrays arrays(cloud);
    Lists lists(arrays.backend, cloud.counts(), cloud.largestRadius());
    const auto build = [&] {
        lists.build(arrays.state(), arrays.particles.constants.view(), arrays.bonds.in());
    };
    build();
    const auto marked = [](uint32_t i, uint32_t j) { return Vec4<float>{float(i), float(j), 1, 0}; };
    const auto before = rowsOf(lists);
    for (uint32_t i = 0; i < before.size(); ++i)
        for (size_t k = 0; k < before[i].size(); ++k)
            lists.contacts().spring.span()[lists.contacts().row_start.span()[i] + k] =
                marked(i, before[i][k]);
    for (auto& item : cloud.items) item.x = axpy(0.004f, item.v, item.x);
    arrays.move(cloud);
    build();
    const auto after = rowsOf(lists);
    ASSERT_NE(before, after);
    size_t kept = 0;
    for (uint32_t i = 0; i < after.size(); ++i)
        for (size_t k = 0; k < after[i].size(); ++k) {
            const uint32_t j = after[i][k];
            const Vec4<float> spring =
                lists.contacts().spring.span()[lists.contacts().row_start.span()[i] + k];
            const bool was = std::binary_search(before[i].begin(), before[i].end(), j);
            ASSERT_EQ(spring.x, was ? float(i) : 0.0f);
            ASSERT_EQ(spring.y, was ? float(j) : 0.0f);
            kept += was;
        }
    EXPECT_GT(kept, 500u);
}

TEST(MayMeet, SeesPathsThatCrossWithinTheHorizonOnly) {
    const Vec4<float> a{0, 0, 0, 0.1f}, b{1, 0, 0, 0.1f}, still{0, 0, 0, 0}, coming{-1, 0, 0, 0},
        leaving{1, 0, 0, 0};
    EXPECT_FALSE(mayMeet(a, still, b, coming, 0.79f));
    EXPECT_TRUE(mayMeet(a, still, b, coming, 0.81f));
    EXPECT_TRUE(mayMeet(a, still, b, coming, 100.0f));  // long past each other by then
    EXPECT_FALSE(mayMeet(a, still, b, leaving, 100.0f));
    EXPECT_FALSE(mayMeet(a, coming, b, coming, 100.0f));  // side by side
    const Vec4<float> aside{1, 0.25f, 0, 0.1f};
    EXPECT_FALSE(mayMeet(a, still, aside, coming, 100.0f));
}

}  // namespace
}  // namespace demolish
