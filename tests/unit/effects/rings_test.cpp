// SPDX-License-Identifier: Apache-2.0
// How what is born in a frame is numbered, and which of it a full ring keeps.
#include "sim_cuda/effects/rings.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace demolish {
namespace {

/// Two faces, a cell and two hits, with so many grains and puffs each.
constexpr SourceCounts kSources{2, 1, 2};
constexpr std::array<uint32_t, 5> kGrains{3, 0, 2, 1, 4}, kPuffs{1, 2, 0, 0, 3};
constexpr std::array<uint32_t, kBirthWords> kBefore{100, 50};

class BirthsOfAFrame : public testing::Test {
  protected:
    BirthsOfAFrame() {
        uint32_t sum = 0;
        for (const auto& counts : {kGrains, kPuffs})
            for (const uint32_t count : counts) {
                sums_.push_back(sum);
                sum += count;
            }
        sums_.push_back(sum);
    }
    Births births(uint32_t first) {
        return {{{grains_.data(), grains_.size()}},
                {{puffs_.data(), puffs_.size()}},
                {kBefore.data(), kBefore.size()},
                {sums_.data(), sums_.size()},
                kSources.all(),
                first};
    }
    std::vector<uint32_t> sums_;
    std::vector<Grain> grains_{4};
    std::vector<Puff> puffs_{64};
};

TEST_F(BirthsOfAFrame, HaveOneNumberAfterTheOtherWhateverThrewThemOff) {
    const std::array<uint32_t, 3> firsts{0, kSources.firstCell(), kSources.firstHit()};
    const std::array<uint32_t, 3> counts{kSources.faces, kSources.cells, kSources.hits};
    uint32_t grain = kBefore[kGrainBirths], puff = kBefore[kPuffBirths];
    for (size_t kind = 0; kind < 3; ++kind)
        for (uint32_t source = 0; source < counts[kind]; ++source) {
            const Births born = births(firsts[kind]);
            ASSERT_EQ(born.grainsOf(source), kGrains[firsts[kind] + source]);
            ASSERT_EQ(born.puffsOf(source), kPuffs[firsts[kind] + source]);
            for (uint32_t k = 0; k < born.grainsOf(source); ++k)
                EXPECT_EQ(born.grainNumber(source, k), grain++);
            for (uint32_t k = 0; k < born.puffsOf(source); ++k) EXPECT_EQ(born.puffNumber(source, k), puff++);
        }
    std::array<uint32_t, kBirthWords> now = kBefore;
    CountBirths{births(0), {now.data(), now.size()}}(0);
    EXPECT_EQ(now[kGrainBirths], grain);
    EXPECT_EQ(now[kPuffBirths], puff);
}

TEST_F(BirthsOfAFrame, LeaveTheLastOnesWhereThereIsNoRoomForAll) {
    // Backwards, as threads may.
    for (uint32_t number = 110; number-- > 100;) {
        Grain grain;
        grain.seed = number;
        births(0).put(number, grain);
    }
    for (uint32_t number = 106; number < 110; ++number) EXPECT_EQ(grains_[number % 4].seed, number);
}

}  // namespace
}  // namespace demolish
