// SPDX-License-Identifier: Apache-2.0
// How a frame is divided into contact steps.
#include "sim_cuda/solver/contact_steps.h"

#include <gtest/gtest.h>

namespace demolish::tests {
namespace {

TEST(ContactSteps, AreAlikeAndCoverAllSubsteps) {
    for (uint32_t n = 1; n < 400; ++n) {
        const ContactSteps steps(n);
        EXPECT_EQ(steps.start(0), 0u);
        EXPECT_EQ(steps.start(steps.count()), n);
        for (uint32_t k = 0; k < steps.count(); ++k) {
            EXPECT_GE(steps.length(k), steps.longest() - 1) << n;
            EXPECT_LE(steps.length(k), steps.longest()) << n;
            EXPECT_LE(steps.length(k), kRigidStride + 1) << n;
            EXPECT_EQ(steps.stepOf(steps.start(k)), k) << n;
            EXPECT_EQ(steps.stepOf(steps.start(k + 1) - 1), k) << n;
        }
    }
}

TEST(ContactSteps, OfMultiplesOfTheStrideHaveItsLength) {
    for (uint32_t n = kRigidStride; n < 400; n += kRigidStride) {
        EXPECT_EQ(ContactSteps(n).count(), n / kRigidStride);
        EXPECT_EQ(ContactSteps(n).longest(), kRigidStride);
    }
}

TEST(ContactSteps, OfManySubstepsAreNoShorterThanTheStride) {
    for (uint32_t n = kRigidStride * kRigidStride; n < 400; ++n)
        EXPECT_GE(ContactSteps(n).length(0), kRigidStride) << n;
}

TEST(ContactSteps, EndWithTheLast) {
    const ContactSteps steps(21);  // 10 and 11
    EXPECT_EQ(steps.untilEnd(1, 0), 10u);
    EXPECT_EQ(steps.untilEnd(1, 3), 7u);
    EXPECT_EQ(steps.untilEnd(2, 3), 18u);
    EXPECT_EQ(steps.untilEnd(4, 10), 11u);
}

}  // namespace
}  // namespace demolish::tests
