// SPDX-License-Identifier: Apache-2.0
// A single pair and its record: bonded, broken, plain contact (physics.md A.6, D 22).
#include "tests/physics/solver/pair_fixture.h"

namespace demolish::tests {
namespace {

TEST_F(Pair, ABrokenPairSpunInPlaceFeelsNoNormalForce) {
    setState(PairState::kBroken);
    now().rotation[0] = {0, 0, 0.7071067811865476, 0.7071067811865476};
    step();
    const double unit = tables_.slots[0].stiffness * kSize;
    EXPECT_LT(force(0), 1e-12 * unit);
    EXPECT_LT(force(1), 1e-12 * unit);
}

TEST_F(Pair, TheCompressiveForceIsContinuousAcrossTheBreak) {
    setDistance(0.99 * kSize);
    step();
    const double bonded = force(0);
    for (uint32_t i = 0; i < 2; ++i) now().velocity[i] = {0, 0, 0, 0};
    setDistance(0.99 * kSize);
    setState(PairState::kBroken);
    step();
    EXPECT_NEAR(force(0) / bonded, 1, 1e-9);
    EXPECT_NEAR(bonded, tables_.slots[0].stiffness * 0.01 * kSize, 1e-6 * bonded);
}

TEST_F(Pair, ABrokenPairNeverPullsAndNeverHeals) {
    setState(PairState::kBroken);
    setDistance(1.02 * kSize);
    step();
    EXPECT_EQ(force(0), 0);
    EXPECT_EQ(state(0), PairState::kBroken);
    setDistance(1.0801 * kSize);
    step();
    EXPECT_EQ(state(0), PairState::kContact);
    EXPECT_EQ(state(1), PairState::kContact);
    setDistance(0.9 * kSize);
    step(5);
    EXPECT_EQ(state(0), PairState::kContact);
    EXPECT_GT(force(0), 0);
}

TEST_F(Pair, WhatIsRigidIsLeftOutWhereTheTwoGoApart) {
    setState(PairState::kContact);
    auto& other = data_.particles.constants.span()[1];
    other = other.seenByOther();  // moved in contact steps
    auto felt = backend_.allocate<Vec4<double>>(2 * size_t{2}),
         tally = backend_.allocate<Vec4<double>>(4 * size_t{2});
    data_.carried = felt.span();
    data_.carried_tally = tally.span();
    for (const bool apart : {true, false}) {
        params_.leaves_out = apart ? 1 : 0;
        keepTouch(kNeverSoftened);
        setDistance(0.9 * kSize);
        step();
        EXPECT_EQ(force(0) > 0, !apart);
        EXPECT_EQ(hasBeenSofter(data_.bonds.spring.view()[0]), !apart);
    }
}

/// Nobody has seen the two come so near: no contact has taken in what such an overlap holds. What comes on
/// top of it does press, and when it grows less, so does what bears nothing.
TEST_F(Pair, WhatTouchesUnseenBearsNothingAtFirst) {
    setState(PairState::kContact);
    EXPECT_LT(forceAt(0.9 * kSize), 1e-6);
    EXPECT_FALSE(holdsNothing(data_.bonds.spring.view()[0]));
    const double more = forceAt(0.89 * kSize);
    EXPECT_GT(more, 0);
    EXPECT_LT(forceAt(0.95 * kSize), 1e-6);
    EXPECT_NEAR(forceAt(0.94 * kSize) / more, 1, 1e-9) << "a hundredth again";
    EXPECT_EQ(forceAt(1.1 * kSize), 0);
    EXPECT_TRUE(holdsNothing(data_.bonds.spring.view()[0]));
}

/// Its part of a spring is told by the normal for which that has been kept: as the pair turns, the tangential
/// spring has a part along the new one.
TEST_F(Pair, WhatTouchedUnseenDoesNotGrowAsThePairTurns) {
    constexpr double kTurn = 0.05, kDistance = 0.9 * kSize, kUnloaded = 1e-3 * kSize, kSpring = 2e-3 * kSize;
    const Vec3<double> turned{std::cos(kTurn), std::sin(kTurn), 0};
    setState(PairState::kContact);
    for (uint32_t i = 0; i < 2; ++i) {
        const double sign = i == 0 ? -1 : 1;
        const Vec3<double> before{0.5 * sign * kDistance, 0, 0}, after = (0.5 * sign * kDistance) * turned;
        now().position[i] = withW(after, 0.0);
        now().velocity[i] = withW((1 / params_.drift) * (after - before), 0.0);
        data_.bonds.spring.span()[i] = {-sign * kUnloaded, -sign * kSpring, 0, -kNeverSoftened};
    }
    step();
    const Vec4<double> kept = data_.bonds.spring.view()[0];
    EXPECT_NEAR(touchOf(kept, turned).unloaded, kUnloaded, 1e-6 * kUnloaded);
}

/// However far two part in one substep: the next touch shall not begin with what this one leaves.
TEST_F(Pair, WhatHasPartedKeepsNoSpring) {
    for (const double distance : {1.005, 1.5, 10.0}) {
        setState(PairState::kContact);
        keepTouch(7, 1e-5);
        setDistance(distance * kSize);
        step();
        for (uint32_t slot = 0; slot < 2; ++slot)
            EXPECT_TRUE(holdsNothing(data_.bonds.spring.view()[slot])) << distance;
    }
}

TEST_F(Pair, TheBondBreaksAtItsStrengthAndNotBefore) {
    const double strength = tables_.body[0].report.strength, area = kSize * kSize;
    const double limit = strength * tables_.slots[0].strength * area / tables_.slots[0].stiffness;
    setDistance(kSize + 0.9995 * limit);
    step();
    EXPECT_EQ(state(0), PairState::kBonded);
    for (uint32_t i = 0; i < 2; ++i) now().velocity[i] = {0, 0, 0, 0};
    setDistance(kSize + 1.0005 * limit);
    step();
    EXPECT_EQ(state(0), PairState::kBroken);
    EXPECT_EQ(state(1), PairState::kBroken);
    // The last pull sets both in motion: what it gives from its middle on, at the velocity after it, is not
    // fracture.
    const double stored = 0.5 * tables_.slots[0].stiffness * limit * limit;
    double booked = 0, moving = 0;
    for (uint32_t i = 0; i < 2; ++i) {
        booked += data_.ledger.view()[i].z;
        moving += 0.5 * tables_.mass[i] * length2(xyz(now().velocity[i]));
    }
    EXPECT_GT(moving, 0.1 * stored);
    EXPECT_NEAR((booked + moving) / stored, 1, 5e-3);
}

}  // namespace
}  // namespace demolish::tests
