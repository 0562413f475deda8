// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {
namespace {

TEST(RigidLoads, APlaceHasWhatRowsAndCollidersGiveIt) {
    RigidLoad<float> rows, colliders;
    rows.push = {{{1, 2, 3}, {}}, 2, 0};
    colliders.push = {{{0, 10, 0}, {}}, 1, 4};
    colliders.tally.contact_loss = 5;
    RigidLoadsOf<float> loads;
    EXPECT_EQ(loads.push().touching, 0u);
    loads.keepRows<true>(rows);
    loads.keepColliders<true>(colliders);
    EXPECT_EQ(loads.push().wrench.force.y, 12);
    EXPECT_EQ(loads.push().touching, 3u);
    EXPECT_EQ(loads.push().coming, 4u);
    EXPECT_EQ(loads.standing(), 1u);
    EXPECT_EQ(loads.tally().contact_loss, 5);
}

/// What only the ledger reads is most of it, and is not written without one.
TEST(RigidLoads, WithoutTheLedgerNothingIsBooked) {
    RigidLoad<float> load;
    load.push.touching = 1;
    load.tally.contact_loss = 5;
    RigidLoadsOf<float> loads;
    loads.keepRows<false>(load);
    EXPECT_EQ(loads.push().touching, 1u);
    EXPECT_EQ(loads.tally().contact_loss, 0);
}

}  // namespace
}  // namespace demolish
