// SPDX-License-Identifier: Apache-2.0
// What a path sets off at full speed has stood until then: where its particles are seen in the substeps of a
// contact step, and what the ledger books of its contacts (decisions/anchors.md).
#include <gtest/gtest.h>

#include "sim_cuda/kernels/integrate.h"
#include "sim_cuda/kernels/start_rigid.h"
#include "sim_cuda/kernels/touch_slots.h"
#include "sim_cuda/solver/rigid_params.h"

namespace demolish {
namespace {

constexpr double kDt = 4e-4, kRadius = 0.05;
constexpr uint32_t kStride = 10;
const Vec3<double> kSetOff{0.5, 0, 2};  ///< m/s

/// A carried particle at the origin that stood until a path has just given it kSetOff, and one that stands.
struct JustLed {
    std::vector<Vec4<double>> led_from = std::vector<Vec4<double>>(4), carried = led_from;
    OwnParticle<double> own;
    SubstepArrays<double> arrays;

    JustLed() {
        led_from[0] = withW(-kSetOff, 0.0);
        own.state.velocity = withW(kSetOff, 0.0);
        own.constants = ParticleConstants<double>{1, 1, kRadius, kRadius}.seenByOther();
        arrays.led_from = {led_from.data(), led_from.size()};
        arrays.carried = {carried.data(), carried.size()};
    }
    /// m, after each substep of a contact step.
    std::vector<double> way() {
        StepParams<double> params;
        params.dt = kDt;
        std::vector<double> gone;
        for (uint32_t k = 0; k < kStride; ++k) {
            params.carry_time = k == 0 ? (1 - 0.5 * kStride) * kDt : kDt;
            own.state = carryOn(arrays, own, {}, params);
            gone.push_back(dot(xyz(own.state.position), kSetOff) / length(kSetOff));
        }
        return gone;
    }
};

TEST(LedContact, WhatIsSetOffIsNeverSeenBehindWhereItStood) {
    const double half_step = 0.5 * kStride * kDt * length(kSetOff);
    const std::vector<double> way = JustLed().way();
    EXPECT_NEAR(way.front(), 0, 1e-12);
    for (size_t k = 1; k < way.size(); ++k) EXPECT_GT(way[k], way[k - 1]);
    EXPECT_NEAR(way.back(), half_step, 0.1 * half_step);
}
TEST(LedContact, WhatGoesOnAsBeforeIsSeenFromHalfAStepBackOn) {
    JustLed steady;
    steady.led_from[0] = {};
    const double half_step = 0.5 * kStride * kDt * length(kSetOff);
    const std::vector<double> way = steady.way();
    EXPECT_NEAR(way.front(), -half_step, 0.2 * half_step + 1e-12);
    EXPECT_NEAR(way.back(), half_step, 1e-12);
}

/// The bonds of what a path leads along come to rest.
JustLed hung() {
    JustLed led;
    Vec4<double> position{}, rotation{0, 0, 0, 1}, velocity = withW(kSetOff, 0.0), spin{}, other[4],
                                                   ledger[8];
    const uint32_t label = 0, now = wordOf(Regime::kRigid), before = wordOf(Regime::kBonded);
    const BodyMemory memory = memoryOf({});
    const auto constants = ParticleConstants<double>::held(kRadius);
    RigidBody body;
    body.velocity = kSetOff;
    Vec3<double> arm;
    Quat<double> turned;
    led.led_from[0] = {};
    SettleRegimes<double> settle;
    settle.in = {{&position, 1}, {&rotation, 1}, {&velocity, 1}, {&spin, 1}};
    settle.state = {{&position, 1}, {&rotation, 1}, {&velocity, 1}, {&spin, 1}};
    settle.other = {{&other[0], 1}, {&other[1], 1}, {&other[2], 1}, {&other[3], 1}};
    settle.constants = {&constants, 1};
    settle.label = {&label, 1};
    settle.regime = settle.pending.regime = {&now, 1};
    settle.former = settle.pending.former = {&before, 1};
    settle.memory = {&memory, 1};
    settle.body = {&body, 1};
    settle.arm = {&arm, 1};
    settle.start_rotation = {&turned, 1};
    settle.ledger = {ledger, 8};
    settle.arrays = led.arrays;
    settle.in_bodies = 1;
    settle.frame_starts = true;
    settle(0);
    return led;
}
TEST(LedContact, WhatSubstepsHaveLedIsSeenFromItsMomentOnWhenItsBondsRest) {
    const double half_step = 0.5 * kStride * kDt * length(kSetOff);
    const std::vector<double> way = hung().way();
    EXPECT_NEAR(way.front(), 0, 1e-12);
    EXPECT_NEAR(way.back(), half_step, 0.1 * half_step);
}

/// J that the ledger books when a touch ends that has hardly pressed, as a path sets one of the two off.
double bookedAtTheEnd(double led) {
    constexpr double kApart = 1e-7, kStiffness = 5e7;
    const StepParams<double> substep = [] {
        StepParams<double> params;
        params.dt = params.drift = kDt;
        params.stiffness_cap = params.own_cap = 1e30;
        return params;
    }();
    OwnParticle<double> own;
    own.constants = {1e-6, 1e-6, kRadius, kRadius};
    PairMotion<double> pair;
    pair.separation = {2 * kRadius + kApart, 0, 0};
    pair.velocity_j = kSetOff;
    PairLaw<double> law;
    law.stiffness = kStiffness;
    Vec4<double> slot{0, 0, 0, kStiffness};
    Tally<double> tally;
    const Vec4<double> held = slot;
    plainContact<true, StepKind::kContact>(rigidParams(substep, kStride, kStride), law, own, own.constants,
                                           {kRadius, kRadius}, pair, centreLine(pair.separation), held, slot,
                                           led, tally);
    EXPECT_TRUE(holdsNothing(slot));
    return tally.contact_loss;
}
TEST(LedContact, ATouchThatEndsAsOneIsSetOffHasNotComeFromInside) {
    EXPECT_LT(bookedAtTheEnd(0), -2e-3);
    EXPECT_EQ(bookedAtTheEnd(-kSetOff.x), 0);
}
TEST(LedContact, TheFormerSpeedOfBothCounts) {
    const JustLed led;
    StepParams<double> params;
    params.dt = params.carry_time = kDt;
    const Vec3<double> normal{1, 0, 0};
    OwnParticle<double> stands;
    stands.id = 1;
    const auto opening = [&]<StepKind kStep>(const OwnParticle<double>& own, uint32_t j,
                                             const ParticleConstants<double>& other) {
        return ledOpening<true, kStep>(led.arrays, params, own, j, other, normal);
    };
    EXPECT_EQ((opening.operator()<StepKind::kContact>(stands, 0, led.own.constants)), -kSetOff.x);
    EXPECT_EQ((opening.operator()<StepKind::kContact>(led.own, 1, stands.constants)), kSetOff.x);
    EXPECT_EQ((opening.operator()<StepKind::kSubstep>(stands, 0, led.own.constants)), -0.5 * kSetOff.x);
    EXPECT_EQ((opening.operator()<StepKind::kSubstep>(stands, 0, stands.constants)), 0);
}

}  // namespace
}  // namespace demolish
