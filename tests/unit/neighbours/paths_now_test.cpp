// SPDX-License-Identifier: Apache-2.0
// What stands between bonds and may be met by a projectile all the same; what comes so fast that the next
// look must be sooner.
#include <gtest/gtest.h>

#include "sim_cuda/kernels/look_at_state.h"
#include "tests/unit/neighbours/bonded_grid.h"
#include "tests/unit/neighbours/particle_cloud.h"

namespace demolish::test {
namespace {

/// 3 x 3 x 3 bonded particles 0.1 m apart, the one in the middle buried; one projectile slot is free to use.
struct Block {
    static constexpr uint32_t kMiddle = 13;
    BondedGrid grid{3, 3, 3};
    Cloud cloud = cloudOf(grid);
    uint32_t shot = cloud.in_bodies;

    static Cloud cloudOf(const BondedGrid& grid) {
        Cloud cloud;
        for (uint32_t i = 0; i < grid.count(); ++i) {
            const auto at = grid.placeOf(i);
            cloud.items.push_back({{0.1f * float(at.x), 0.1f * float(at.y), 0.1f * float(at.z)}, {}, 0.05f});
        }
        cloud.addProjectileSlots();
        return cloud;
    }
    std::vector<uint32_t> buried() const {
        std::vector<uint32_t> marks(cloud.in_bodies);
        marks[kMiddle] = 1;
        return marks;
    }
};

/// Lists of a block, built.
struct BuiltBlock {
    CloudArrays arrays;
    NeighbourLists<CpuBackend, float> lists;

    explicit BuiltBlock(const Block& block, const NeighbourSettings& settings = {})
        : arrays(block.cloud),
          lists(arrays.backend, block.cloud.counts(), block.cloud.largestRadius(), settings) {
        setBonds(block);
        lists.setBuried(block.buried());
        lists.build(arrays.state(), arrays.particles.constants.view(), arrays.bonds.in());
    }
    void setBonds(const Block& block) {
        arrays.bonds.row_start = arrays.backend.uploaded(block.grid.row_start);
        arrays.bonds.link = arrays.backend.uploaded(block.grid.link);
    }
    PathsNow<float> paths(float lookahead = 0) const {
        return {arrays.state(), lists.contacts().paths(), 0, lookahead, lists.enclosures(arrays.bonds.in())};
    }
    bool listsMiddleWith(uint32_t other) const {
        const auto rows = lists.contacts().in();
        return findContact(rows.row_start, rows.neighbour, Block::kMiddle, other) <
               rows.row_start[Block::kMiddle + 1];
    }
};

TEST(Enclosed, IsListedWhereAProjectileMayReachItAndOnlyThere) {
    Block block;
    block.cloud.items[block.shot] = {{0.1f, 0.1f, 0.4f}, {0, 0, -10}, 0.05f, true};
    EXPECT_TRUE(BuiltBlock{block}.listsMiddleWith(block.shot));
    block.cloud.items[block.shot].v = {10, 0, 0};
    EXPECT_FALSE(BuiltBlock{block}.listsMiddleWith(block.shot)) << "it flies past";
}

/// Of particles 13 (the middle one), 14 beside it and 5 beside 14.
TEST(Enclosed, HoldsDeeplyWhileTheBondsAboutItHoldToo) {
    Block block;
    BuiltBlock built{block};
    const auto enclosures = [&] { return built.lists.enclosures(built.arrays.bonds.in()); };
    const auto middleIsHeldDeeply = [&] {
        std::vector<uint8_t> uncracked(block.cloud.in_bodies);
        for (uint32_t i = 0; i < block.cloud.in_bodies; ++i)
            MarkUncracked{enclosures(), {uncracked.data(), uncracked.size()}}(i);
        return enclosures().holdDeeply(Block::kMiddle,
                                       Span<const uint8_t>(uncracked.data(), uncracked.size()));
    };
    EXPECT_TRUE(enclosures().hold(Block::kMiddle));
    EXPECT_TRUE(middleIsHeldDeeply());
    EXPECT_FALSE(enclosures().hold(0)) << "is not buried";
    block.grid.setState(0, 1, PairState::kBroken);
    built.setBonds(block);
    EXPECT_TRUE(middleIsHeldDeeply()) << "neither is bonded to the middle";
    block.grid.setState(5, 14, PairState::kBroken);
    built.setBonds(block);
    EXPECT_TRUE(enclosures().hold(Block::kMiddle));
    EXPECT_FALSE(middleIsHeldDeeply());
    block.grid.setState(Block::kMiddle, 14, PairState::kBroken);
    built.setBonds(block);
    EXPECT_FALSE(enclosures().hold(Block::kMiddle));
}

/// It flies past at a distance that it would cross within 0.02 s.
TEST(Projectile, IsListedWithWhatMayBeThrownAtItBeforeTheListsKnow) {
    Block block;
    block.cloud.items[block.shot] = {{0.25f, 0.1f, 0.4f}, {0, 0, -10}, 0.05f, true};
    EXPECT_FALSE(BuiltBlock{block}.listsMiddleWith(block.shot));
    EXPECT_TRUE((BuiltBlock{block, {.blind_time = 0.02}}.listsMiddleWith(block.shot)));
    block.cloud.items[block.shot].v = {0, 0, -0.1f};
    EXPECT_FALSE((BuiltBlock{block, {.blind_time = 0.02}}.listsMiddleWith(block.shot))) << "it is slow";
}

}  // namespace
}  // namespace demolish::test
