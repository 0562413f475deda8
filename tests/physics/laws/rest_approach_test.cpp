// SPDX-License-Identifier: Apache-2.0
// Contact steps end slow bouncing: below a speed of approach their dampers go by the fragment's share.
#include <gtest/gtest.h>

#include <random>

#include "tests/physics/laws/random_pairs.h"

namespace demolish {
namespace {

template <class T>
struct ContactStepTouch {
    DEM_FN TouchEffect<T> operator()(const TouchGeometry<T>& at, const TouchLaw<T>& law,
                                     const PairMotion<T>& pair, const Vec3<T>& spring, T dt) const {
        return touchEffect<StepKind::kContact>(at, law, pair, spring, dt);
    }
};
template <class T>
struct ContactStepLaw {
    DEM_FN TouchLaw<T> operator()(const PairLaw<T>& pair, const StepParams<T>& params, T overlap, T radius,
                                  const PairInertia<T>& against) const {
        return contactTouchLaw<StepKind::kContact>(pair, params, overlap, radius, against);
    }
};

constexpr double kDt = 1e-4;  // s

/// Pressed together, approaching at `speed` (m/s) along the normal, without friction.
TouchEffect<double> pressed(double speed, bool contact_step) {
    TouchLaw<double> law;
    law.stiffness = 1e5;
    law.elastic = 100;
    law.normal_damping = 40;
    law.resting = 120;
    const TouchGeometry<double> at{{1, 0, 0}, 1e-3, 0.02, 0.02};
    PairMotion<double> pair;
    pair.velocity_i = {speed, 0, 0};
    return contact_step ? laws::evaluate(ContactStepTouch<double>{}, at, law, pair, Vec3<double>{}, kDt)
                        : laws::touchEffect(at, law, pair, Vec3<double>{}, kDt);
}

TEST(RestApproach, IsAsInSubstepsAboveTheRestSpeed) {
    for (const double speed : {0.2, 0.5, -0.3, 4.0})
        EXPECT_EQ(pressed(speed, true).load.force.x, pressed(speed, false).load.force.x) << speed;
}

TEST(RestApproach, DampsByTheShareAtRestAndPassesOverWithoutAJump) {
    // Per speed: of an approach that is almost none, the whole damper.
    EXPECT_NEAR((100 + pressed(1e-4, true).load.force.x) / -1e-4, 160, 1e-3);
    EXPECT_NEAR((100 + pressed(1e-4, false).load.force.x) / -1e-4, 40, 1e-3);
    for (double speed = 0; speed < 0.3; speed += 1e-4) {
        const double here = -pressed(speed, true).load.force.x,
                     next = -pressed(speed + 1e-4, true).load.force.x;
        ASSERT_NEAR(here, next, 201 * 1e-4) << speed;
        ASSERT_GE(here, -pressed(speed, false).load.force.x) << speed;
    }
}

template <class T>
void expectOddAndDissipative() {
    std::mt19937 random(5);
    int slow = 0;
    for (int k = 0; k < 300; ++k) {
        auto p = test::drawTouchingPair<T>(random);
        p.motion.velocity_i = T(0.05) * p.motion.velocity_i;
        p.motion.velocity_j = T(0.05) * p.motion.velocity_j;
        p.motion.spin_i = T(0.05) * p.motion.spin_i;
        p.motion.spin_j = T(0.05) * p.motion.spin_j;
        p.law.resting = T(3) * p.law.normal_damping;
        p.law.shear_resting = T(2) * p.law.shear_damping;
        const auto q = test::exchanged(p);
        const auto a = laws::evaluate(ContactStepTouch<T>{}, p.geometry, p.law, p.motion, p.spring, T(kDt));
        const auto b = laws::evaluate(ContactStepTouch<T>{}, q.geometry, q.law, q.motion, q.spring, T(kDt));
        ASSERT_EQ(length2(a.load.force + b.load.force), T(0));
        ASSERT_EQ(length2(a.spring + b.spring), T(0));
        // The damper's force on i never drives the two along their way.
        ASSERT_GE(dot(a.damping.force, p.geometry.normal) * a.opening, T(0));
        slow += a.opening * a.opening < T(kRestApproach * kRestApproach);
    }
    EXPECT_GT(slow, 100);
}

TEST(RestApproach, IsOddAndTakesEnergyOnly) {
    expectOddAndDissipative<float>();
    expectOddAndDissipative<double>();
}

TEST(RestApproach, GrowsToTheDamperOfTheShareWithinTheCapOfTheTangentialOne) {
    for (const uint32_t hertz : {0u, 1u}) {
        const PairLaw<double> pair{1e5, 2.5, 0.5, 0.3, 0, 2e7, 8e6};
        StepParams<double> params;
        params.hertz = hertz;
        params.softening = 1;
        params.dt = 1e-3;
        params.stiffness_cap = 0.12 / (params.dt * params.dt);
        // 8 kg stand behind a particle of half a kilogram.
        const PairInertia<double> against{1 / 8.0, 1 / 0.5};
        const TouchLaw<double> law =
            laws::evaluate(ContactStepLaw<double>{}, pair, params, 1e-3, 0.02, against);
        EXPECT_NEAR((law.normal_damping + law.resting) / law.normal_damping, 4, 1e-5);
        const double cap = kShearDampingShare * 8 / params.dt;
        EXPECT_LE(law.shear_damping + law.shear_resting, cap * (1 + 1e-6));
        EXPECT_GE(law.shear_resting, 0);
        // A particle heavier than its share keeps its own damper.
        const PairInertia<double> heavy{1 / 0.5, 1 / 8.0};
        EXPECT_EQ(laws::evaluate(ContactStepLaw<double>{}, pair, params, 1e-3, 0.02, heavy).resting, 0);
    }
}

}  // namespace
}  // namespace demolish
