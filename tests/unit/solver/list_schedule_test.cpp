// SPDX-License-Identifier: Apache-2.0
// When contact lists are made anew.
#include "sim_cuda/solver/list_schedule.h"

#include <gtest/gtest.h>

#include <utility>

#include "sim_cuda/physics/rigid_motion.h"
#include "sim_cuda/solver/look_interval.h"

namespace demolish::tests {
namespace {

constexpr double kStep = 1e-4, kHorizon = 0.01;  // s: 100 substeps

/// Just built.
ListSchedule fresh() {
    ListSchedule lists(kStep);
    lists.built();
    return lists;
}

TEST(ListSchedule, TheyAreDueAtTheStartAndNoLongerOnceBuilt) {
    ListSchedule lists(kStep);
    EXPECT_TRUE(lists.due());
    lists.built();
    EXPECT_FALSE(lists.due());
    EXPECT_EQ(lists.age(), 0);
    lists.demand();
    EXPECT_TRUE(lists.due());
}

TEST(ListSchedule, TheyAreDueWhenTheNextStretchWouldPassTheirHorizon) {
    ListSchedule lists = fresh();
    lists.pass(80);
    EXPECT_FALSE(lists.judge(false, true, 19, kHorizon));
    EXPECT_FALSE(lists.due());
    EXPECT_FALSE(lists.judge(false, true, 21, kHorizon));
    EXPECT_TRUE(lists.due());
}

TEST(ListSchedule, TheyCanBeKeptForAFewWhoLeaveTheirPathsWhileTheyHoldAndAllIsWell) {
    const auto judged = [](bool state_is_good, uint32_t next) {
        ListSchedule lists = fresh();
        lists.pass(80);
        const bool kept = lists.judge(true, state_is_good, next, kHorizon);
        EXPECT_EQ(lists.due(), !kept);
        return kept;
    };
    EXPECT_TRUE(judged(true, 19));
    EXPECT_FALSE(judged(true, 21));
    EXPECT_FALSE(judged(false, 19));
}

TEST(ListSchedule, NextOnesLastTwiceAsLongAsListsHaveLastedOfLate) {
    ListSchedule lists = fresh();
    for (int k = 0; k < 5; ++k) {  // a life of 10,000 at the start is halved with each build
        lists.pass(500);
        lists.next(false, false, kRigidStride);
        lists.built();
    }
    lists.pass(500);
    EXPECT_DOUBLE_EQ(lists.next(false, false, kRigidStride).longest_horizon, 2 * 500 * kStep);
}

TEST(ListSchedule, AProjectileSaysNothingAboutHowLongTheyLast) {
    ListSchedule lists = fresh();
    lists.pass(1);
    EXPECT_EQ(lists.next(false, true, kRigidStride).longest_horizon, NeighbourSettings{}.longest_horizon);
    EXPECT_EQ(lists.state().life, ListSchedule::State{}.life);
}

TEST(ListSchedule, TheyLastTwoStretchesAtLeastAndRigidBodiesHaveTheirOwnBounds) {
    ListSchedule lists = fresh();
    NeighbourSettings settings;
    for (int k = 0; k < 20; ++k) settings = lists.next(false, false, kRigidStride);
    EXPECT_DOUBLE_EQ(settings.longest_horizon, 2 * 2 * kRigidStretch.length() * kStep);
    ListSchedule other = fresh();
    EXPECT_EQ(other.next(true, true, kRigidStride).longest_horizon, kRigidNeighbours.longest_horizon);
    EXPECT_EQ(other.next(true, true, kRigidStride).skin_share, kRigidNeighbours.skin_share);
}

TEST(ListSchedule, WhatRemainsEndsWithTheHorizonOrTheFrame) {
    ListSchedule lists = fresh();
    lists.pass(40);
    EXPECT_DOUBLE_EQ(lists.remaining(kHorizon, 1000), kHorizon - 40 * kStep);
    EXPECT_DOUBLE_EQ(lists.remaining(kHorizon, 10), 10 * kStep);
    lists.pass(100);
    EXPECT_EQ(lists.remaining(kHorizon, 10), 0);
}

/// A stretch beyond their horizon would be gone through unseen; others end as they did.
TEST(ListSchedule, TheyEndAStretchForWhichTheyDoNotLast) {
    ListSchedule lists = fresh();
    EXPECT_EQ(lists.lastFor(kHorizon, 101, 1000), 100u);
    EXPECT_EQ(lists.lastFor(kHorizon, 101, 30), 30u);
    lists.pass(40);
    EXPECT_EQ(lists.lastFor(kHorizon, 101, 1000), 60u);
    EXPECT_EQ(lists.lastFor(kHorizon, 99, 1000), 1000u);
    lists.pass(100);
    EXPECT_EQ(lists.lastFor(kHorizon, 101, 1000), 0u);
}

TEST(ListSchedule, ListsReckonWithTheTimeInWhichAHitIsNotKnown) {
    EXPECT_GE(fresh().next(false, false, kRigidStride).blind_time, kBondedStretch.blind() * kStep);
    EXPECT_GE(fresh().next(true, false, kRigidStride).blind_time, kRigidStretch.blind() * kStep);
    EXPECT_EQ((Stretch{30, 10}.blind()), 50u) << "a hit after the look, the next one, and its answer";
}

}  // namespace
}  // namespace demolish::tests
