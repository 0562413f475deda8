// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {
namespace {

/// Graphs on a GPU are kept for a memory and used for more and fewer places.
TEST(RigidLoads, WhereAPlaceLiesDependsOnNoLength) {
    std::vector<RigidLoad<float>> memory(RigidLoads<float>::needed(300));
    const RigidLoads<float> few{{memory.data(), RigidLoads<float>::needed(7)}},
        many{{memory.data(), memory.size()}};
    for (uint32_t place = 0; place < 7; ++place) {
        EXPECT_EQ(&few.ofRows(place), &many.ofRows(place));
        EXPECT_EQ(&few.ofColliders(place), &many.ofColliders(place));
    }
    EXPECT_EQ(&many.ofColliders(299), &memory.back());
}

TEST(RigidLoads, APlaceHasWhatRowsAndCollidersGiveIt) {
    std::vector<RigidLoad<float>> memory(RigidLoads<float>::needed(2));
    const RigidLoads<float> loads{{memory.data(), memory.size()}};
    loads.ofRows(1).wrench.force = {1, 2, 3};
    loads.ofRows(1).touching = 2;
    loads.ofColliders(1).wrench.force = {0, 10, 0};
    loads.ofColliders(1).touching = 1;
    loads.ofColliders(1).coming = 4;
    loads.ofColliders(1).tally.contact_loss = 5;
    const RigidLoad<float> sum = loads.at(1);
    EXPECT_EQ(sum.wrench.force.y, 12);
    EXPECT_EQ(sum.touching, 3u);
    EXPECT_EQ(sum.coming, 4u);
    EXPECT_EQ(sum.tally.contact_loss, 5);
    EXPECT_EQ(loads.at(0).touching, 0u);
}

}  // namespace
}  // namespace demolish
