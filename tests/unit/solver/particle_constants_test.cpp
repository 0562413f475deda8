// SPDX-License-Identifier: Apache-2.0
// Who moves a particle, and its mass, whoever does.
#include <gtest/gtest.h>

#include <type_traits>

#include "sim_cuda/data/particles.h"

namespace demolish::tests {
namespace {

TEST(ParticleConstants, AnEmptySlotIsMovedByNobodyInEitherKindOfStep) {
    const ParticleConstants<float> empty;
    EXPECT_EQ(empty.mover(), Mover::kNobody);
    EXPECT_EQ(empty.seenByOther().mover(), Mover::kNobody);
    EXPECT_FALSE(empty.takesPart());
    EXPECT_EQ(empty.inverseMass(), 0);
}

TEST(ParticleConstants, WhatOneKindOfStepMovesTheOtherSeesAsMovedByTheOther) {
    const ParticleConstants<float> own{0.5f, 90.0f, 0.01f, 0.02f}, seen = own.seenByOther();
    EXPECT_EQ(own.mover(), Mover::kThisStep);
    EXPECT_TRUE(own.takesPart());
    EXPECT_EQ(seen.mover(), Mover::kOtherStep);
    EXPECT_EQ(seen.seenByOther().mover(), Mover::kThisStep);
    for (const auto& constants : {own, seen}) {
        EXPECT_EQ(constants.inverseMass(), 0.5f) << "the mass does not depend on who asks";
        EXPECT_EQ(constants.inverse_inertia, 90.0f);
        EXPECT_EQ(constants.contact_radius, 0.01f);
        EXPECT_EQ(constants.floor_radius, 0.02f);
    }
}

TEST(ParticleConstants, WhatIsHeldTakesPartAndNothingMovesIt) {
    const auto held = ParticleConstants<float>::held(0.01f);
    EXPECT_TRUE(held.isHeld() && held.seenByOther().isHeld());
    EXPECT_TRUE(held.takesPart());
    EXPECT_EQ(held.mover(), Mover::kThisStep);
    EXPECT_EQ(held.seenByOther().mover(), Mover::kOtherStep);
    const ParticleConstants<float> light{1000.0f, 90.0f, 0.01f, 0.02f};
    EXPECT_FALSE(light.isHeld());
    EXPECT_EQ(held.inverseMass() + light.inverseMass(), light.inverseMass()) << "the other bears it all";
}

TEST(ParticleConstants, TheyComeWithOneLoadOfFourNumbers) {
    static_assert(sizeof(ParticleConstants<float>) == 16 && alignof(ParticleConstants<float>) == 16);
    static_assert(sizeof(ParticleConstants<double>) == 32 && alignof(ParticleConstants<double>) == 32);
    static_assert(std::is_trivially_copyable_v<ParticleConstants<float>>);
}

}  // namespace
}  // namespace demolish::tests
