// SPDX-License-Identifier: Apache-2.0
// How far broken bonds have opened: what cracks are as wide as.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "sim_cuda/kernels/measure_openings.h"

namespace demolish::tests {
namespace {

/// Three particles in a row along x, 0.1 m apart at rest, each bonded to the next.
struct Row {
    std::vector<Vec4<float>> position, rotation{3}, velocity{3}, spin{3};
    std::vector<uint32_t> row_start{0, 1, 3, 4}, slot_of_bond{0, 2}, twin{1, 0, 3, 2};
    std::vector<BondLink> link;
    std::vector<Vec4<float>> rest{{0.1f, 0, 0, 1}, {-0.1f, 0, 0, 1}, {0.1f, 0, 0, 1}, {-0.1f, 0, 0, 1}};

    Row(const std::array<float, 3>& x, PairState first, PairState second) {
        for (const float along : x) position.push_back({along, 2, 3, 0});
        link = {{linkWord(1, first)}, {linkWord(0, first)}, {linkWord(2, second)}, {linkWord(1, second)}};
    }
    std::vector<float> openings() const {
        const auto view = [](const auto& values) { return Span(values.data(), values.size()); };
        std::vector<float> opening(2, -1);
        const MeasureOpenings<float> kernel{{view(position), view(rotation), view(velocity), view(spin)},
                                            {view(row_start), view(link), view(rest), {}},
                                            view(slot_of_bond),
                                            view(twin),
                                            {opening.data(), opening.size()}};
        for (uint32_t b = 0; b < 2; ++b) kernel(b);
        return opening;
    }
};

TEST(Openings, AreTheDistanceBeyondThatAtRest) {
    const auto opening = Row({0, 0.1f, 0.2015f}, PairState::kBroken, PairState::kBroken).openings();
    EXPECT_NEAR(opening[0], 0, 1e-8);
    EXPECT_NEAR(opening[1], 0.0015f, 1e-7);
}

TEST(Openings, AreNoneWhereBondsHoldOrPressTogether) {
    const auto opening = Row({0, 0.11f, 0.2f}, PairState::kBonded, PairState::kBroken).openings();
    EXPECT_EQ(opening[0], 0);
    EXPECT_EQ(opening[1], 0);
}

/// A thousandth of a millimetre, a kilometre from the origin.
TEST(Openings, KeepTheBitsOfBothPartsOfAPosition) {
    Row row({1000, 1000.125f, 1000.25f}, PairState::kBroken, PairState::kBroken);
    for (auto& rest : row.rest) rest.x *= 1.25f;
    row.position[2].w = 1e-6f;
    EXPECT_NEAR(row.openings()[0], 0, 1e-8);
    EXPECT_NEAR(row.openings()[1], 1e-6f, 2e-8);
}

}  // namespace
}  // namespace demolish::tests
