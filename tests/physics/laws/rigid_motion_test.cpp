// SPDX-License-Identifier: Apache-2.0
// Rigid bodies between two kinds of step: gravity, and a turn without a torque.
#include <gtest/gtest.h>

#include "sim_cuda/data/regimes.h"
#include "tests/physics/laws/laws.h"

namespace demolish {
namespace {

/// What a call leaves in the flight that it is given.
struct Fallen {
    Flight flight;
    double substeps = 0;
};
struct Fall {
    DEM_FN Fallen operator()(Flight flight, uint32_t before, uint32_t stride, bool touched) const {
        const double substeps = fallenSubsteps(flight, before, stride, touched);
        return {flight, substeps};
    }
};
double fallenIn(Flight& flight, uint32_t before, uint32_t stride, bool touched) {
    const Fallen fallen = laws::evaluate(Fall{}, flight, before, stride, touched);
    flight = fallen.flight;
    return fallen.substeps;
}

/// Substeps of gravity in steps of these lengths, one after the other, with nothing that touches.
double fallen(Flight& flight, std::initializer_list<uint32_t> strides) {
    double sum = 0;
    for (const uint32_t stride : strides) sum += fallenIn(flight, stride, stride, false);
    return sum;
}

TEST(Flight, LagsByHalfAStepLessHalfASubstep) {
    Flight flight;
    EXPECT_EQ(fallen(flight, {10}), 5.5) << "from half a substep before to half a contact step after";
    EXPECT_EQ(flight.lag, 9);
    EXPECT_EQ(flight.free, 1u);
    EXPECT_EQ(fallen(flight, {10, 10}), 20);
}

TEST(Flight, WhatIsCaughtUpIsWhatSubstepsFallWhateverTheSteps) {
    for (const auto& strides :
         {std::initializer_list<uint32_t>{10, 10, 10}, {10, 7}, {1, 1, 10}, {3, 10, 4}}) {
        Flight flight;
        uint32_t substeps = 0;
        for (const uint32_t stride : strides) substeps += stride;
        EXPECT_EQ(fallen(flight, strides) + 0.5 * flight.lag, substeps);
    }
}

TEST(Flight, GravityGoesOnWithTheContactsOfWhatIsTouched) {
    Flight flight;
    EXPECT_EQ(fallenIn(flight, 10, 10, true), 10);
    EXPECT_EQ(flight.lag, 0);
    EXPECT_EQ(flight.free, 0u);
    (void)fallen(flight, {10});
    EXPECT_EQ(fallenIn(flight, 10, 10, true), 10) << "a bounce keeps the lag";
    EXPECT_EQ(flight.lag, 9);
    EXPECT_EQ(flight.free, 0u);
}

TEST(Flight, WhatLiesIsPulledForAsLongAsItIsPushedHoweverStepsChangeTheirLength) {
    Flight flight;
    double substeps = 0;
    uint32_t before = 1, passed = 0;
    for (const uint32_t stride : {10u, 10u, 5u, 10u, 3u, 4u}) {
        const double pulled = fallenIn(flight, before, stride, true);
        EXPECT_EQ(pulled, pushedSubsteps(before, stride)) << "after " << before << ", in " << stride;
        substeps += pulled;
        passed += stride;
        before = stride;
    }
    EXPECT_EQ(substeps + 0.5 * flight.lag, passed) << "and nothing of the fall is lost";
}

TEST(Flight, IsRememberedWithItsSign) {
    for (const int32_t lag : {-9, 0, 9}) {
        RigidBody body;
        body.contacts = 77;
        body.standing = 70;
        body.flight = {lag, 1};
        EXPECT_EQ(rememberedFlight(memoryOf(body)).lag, lag);
        EXPECT_EQ(rememberedFlight(memoryOf(body)).free, 1u);
        EXPECT_EQ(rememberedContacts(memoryOf(body)), 77u);
        EXPECT_EQ(memoryOf(body).standing, 70u);
    }
}

TEST(Flight, WhatTouchesPushesFromTheMiddleOfAStepToTheMiddleOfTheNext) {
    EXPECT_EQ(pushedSubsteps(10, 10), 10);
    EXPECT_EQ(pushedSubsteps(10, 4), 7);
    EXPECT_EQ(pushedSubsteps(4, 10), 7);
}

RigidBody spinningBrick() {
    RigidBody body;
    body.inverse_mass = 0.5;
    body.inverse_inertia = {1, 1.0 / 2, 1.0 / 3, 0.05, 0, 0.02};
    body.angular = {1, 6, 0.1};
    return body;
}
double energyOf(const RigidBody& body) {
    return 0.5 * dot(laws::spinAt(body, body.turned), body.angular);
}

/// So many steps with nothing that acts, then the body.
struct Turn {
    DEM_FN RigidBody operator()(RigidBody body, double dt, int steps) const {
        for (int k = 0; k < steps; ++k) advance(body, {}, {}, {}, dt);
        return body;
    }
};

TEST(RigidMotion, TurnsWithoutATorqueAtConstantEnergy) {
    const auto drift = [](double dt) {
        const double before = energyOf(spinningBrick());
        const RigidBody body =
            laws::evaluate(Turn{}, spinningBrick(), dt, static_cast<int>(std::lround(10 / dt)));
        EXPECT_EQ(body.angular.y, 6);
        return std::abs(energyOf(body) / before - 1);
    };
    EXPECT_LT(drift(0.01), 1e-4);
    EXPECT_LT(drift(0.005), 0.5 * drift(0.01)) << "the error falls faster than the step";
}

struct Push {
    DEM_FN RigidBody operator()(RigidBody body) const {
        advance(body, {0.4, 0, 0}, {}, {0, -1, 0}, 0.1);
        return body;
    }
};

TEST(RigidMotion, FallsAsAParticle) {
    const RigidBody body = laws::evaluate(Push{}, spinningBrick());
    EXPECT_DOUBLE_EQ(body.velocity.x, 0.2);
    EXPECT_DOUBLE_EQ(body.velocity.y, -1);
    EXPECT_DOUBLE_EQ(body.centre.y, -0.1);
    EXPECT_DOUBLE_EQ(laws::velocityAt(body.velocity, body.spin, Vec3<double>{}).y, -1);
}

}  // namespace
}  // namespace demolish
