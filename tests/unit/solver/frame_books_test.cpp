// SPDX-License-Identifier: Apache-2.0
// What a run reports, added up frame by frame.
#include "sim_cuda/solver/frame_books.h"

#include <gtest/gtest.h>

namespace demolish::tests {
namespace {

FrameSums sumsOf(uint32_t broken, uint32_t parted = 0) {
    FrameSums sums;
    sums.damping = 1;
    sums.friction = 2;
    sums.fracture = 3;
    sums.stress = 0.5;
    sums.broken = broken;
    sums.parted = parted;
    return sums;
}

FrameBooks books() {
    return {1e-4, 8, 100, 250};
}

TEST(FrameBooks, EnergiesOfFramesAddUpWhileTheyAreBooked) {
    FrameBooks books = tests::books();
    books.addSums(sumsOf(0), true, 7);
    books.addSums(sumsOf(0), false, 7);
    books.addSums(sumsOf(0), true, 9);
    const EnergyLedger& energy = books.stats().energy;
    EXPECT_EQ(energy.damping, 2);
    EXPECT_EQ(energy.friction, 4);
    EXPECT_EQ(energy.fracture, 6);
    EXPECT_EQ(energy.external, 9);
    EXPECT_EQ(books.stats().max_stress_ratio, 0.5);
}

TEST(FrameBooks, OnlyAFrameInWhichBondsBreakSaysSo) {
    FrameBooks books = tests::books();
    const auto after = [&](uint32_t broken) {
        books.closeFrame(10, 0, 0);
        books.addSums(sumsOf(broken, broken / 2), true, 0);
        return books.stats().fracture_changed;
    };
    EXPECT_FALSE(after(0));
    EXPECT_TRUE(after(4));
    EXPECT_EQ(books.stats().bonds_broken, 4u);
    EXPECT_EQ(books.stats().bonds_parted, 2u);
    EXPECT_FALSE(after(4));
    EXPECT_TRUE(after(5));
    books.closeFrame(10, 0, 0);  // nothing has happened in it
    EXPECT_FALSE(books.stats().fracture_changed);
    EXPECT_EQ(books.stats().bonds_broken, 5u);
}

TEST(FrameBooks, FramesAreCounted) {
    FrameBooks books = tests::books();
    books.closeFrame(300, 0.03, 2);
    books.closeFrame(150, 0.045, 0);
    EXPECT_EQ(books.stats().frame, 2u);
    EXPECT_EQ(books.stats().substeps, 150u);
    EXPECT_EQ(books.stats().time, 0.045);
    EXPECT_EQ(books.stats().list_rebuilds, 0u);
}

TEST(FrameBooks, TheLargestFragmentIsAShareOfTheMass) {
    FrameBooks books = tests::books();
    books.setFragments({3, 2});
    EXPECT_EQ(books.stats().fragments, 3u);
    EXPECT_EQ(books.stats().largest_fragment_fraction, 0.25);
}

TEST(FrameBooks, AStateThatIsResumedGoesOnAndKnowsNoEnergiesOfTheMoment) {
    FrameBooks books = tests::books();
    books.closeFrame(10, 0.001, 0);
    books.addSums(sumsOf(4), true, 0);
    const FrameBooks::State state = books.state();
    MechanicalSums measured;
    measured.kinetic = 11;
    books.setMechanical(measured, 0);
    books.closeFrame(10, 0.002, 0);
    books.addSums(sumsOf(9), true, 5);
    EXPECT_EQ(books.stats().energy.kinetic, 11) << "those of the last measurement stay";
    books.setStatus(StepStatus::kNotFinite);
    books.resume(state, 2, 0.001);
    EXPECT_EQ(books.stats().status, StepStatus::kOk);
    EXPECT_EQ(books.stats().frame, 1u);
    EXPECT_EQ(books.stats().time, 0.001);
    EXPECT_EQ(books.stats().bonds_broken, 4u);
    EXPECT_EQ(books.stats().energy.damping, 1);
    EXPECT_EQ(books.stats().energy.external, 2);
    EXPECT_EQ(books.stats().energy.kinetic, 0);
    books.addSums(sumsOf(4), true, 2);
    EXPECT_EQ(books.stats().energy.damping, 2);
    EXPECT_FALSE(books.stats().fracture_changed);
}

}  // namespace
}  // namespace demolish::tests
