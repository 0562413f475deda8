// SPDX-License-Identifier: Apache-2.0
// A touch with a collider that rests gets its stiffness back (decisions/contact_laws.md), and what that gives
// is booked.
#include <gtest/gtest.h>

#include "sim_cuda/kernels/landing.h"
#include "sim_cuda/physics/touch_effect.h"

namespace demolish {
namespace {

StepParams<double> steps(double seconds) {
    StepParams<double> params;
    params.dt = params.drift = seconds;
    return params;
}

TEST(HardenedTouch, GrowsWhereItRestsInContactSteps) {
    constexpr StepKind kContact = StepKind::kContact;
    StepParams<double> params = steps(1e-3);
    const Vec4<double> kept{1, 2, 3, 100}, hard{1, 2, 3, -100};
    const double grown = 100 * (1 + kHardening * params.dt);
    EXPECT_DOUBLE_EQ(hardened<kContact>(params, 0.5 * kRestSpeed, kept).w, grown);
    EXPECT_DOUBLE_EQ(hardened<kContact>(params, -0.5 * kRestSpeed, hard).w, -grown);
    EXPECT_EQ(hardened<kContact>(params, 0.5 * kRestSpeed, kept).x, kept.x);

    EXPECT_EQ(hardened<kContact>(params, 2 * kRestSpeed, kept).w, 100);
    EXPECT_EQ(hardened<StepKind::kSubstep>(params, 0.0, kept).w, 100);
    EXPECT_EQ(hardened<kContact>(params, 0.0, {}).w, 0);
    EXPECT_EQ(hardened<kContact>(params, 0.0, {0, 0, 0, kNeverSoftened}).w, kNeverSoftened);
    params.drift = 2 * params.dt;
    EXPECT_EQ(hardened<kContact>(params, 0.0, kept).w, 100) << "a short step";
}

/// A mass swings on a spring that grows fourfold: energies and what is booked stay together.
TEST(HardenedTouch, BooksWhatItGives) {
    constexpr double kMass = 0.02, kGravity = 9.81, kStep = 1e-3;
    const StepParams<double> params = steps(kStep);
    TouchLaw<double> law;
    law.softens = true;
    double stiffness = 400, depth = kMass * kGravity / stiffness, sinking = 0.005, booked = 0, start = 0;
    for (int k = 0; stiffness < 1600; ++k) {
        const double before = depth - kStep * sinking, kept = stiffness;
        if (k > 0) stiffness = hardened<StepKind::kContact>(params, 0.0, {0, 0, 0, kept}).w;
        law.stiffness = stiffness;
        if (k > 0) booked += softeningLoss(law, kept, overlapChange(depth, before), {});
        const double after = sinking + kStep * (kGravity - stiffness * depth / kMass);
        const double energy =
            0.5 * kMass * sinking * after + 0.5 * stiffness * depth * depth - kMass * kGravity * depth;
        if (k == 0) start = energy;
        ASSERT_NEAR(energy + booked, start, 1e-12) << k;
        sinking = after;
        depth += kStep * sinking;
        ASSERT_GT(depth, 0) << k;
    }
    EXPECT_LT(booked, -3e-5);
}

}  // namespace
}  // namespace demolish
