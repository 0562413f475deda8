// SPDX-License-Identifier: Apache-2.0
// What was measured is found again, for the same body and setting alone.
#include "app/session/threshold_cache.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

BreakableBody body() {
    BreakableBody body;
    body.particles.resize(3);
    for (size_t i = 0; i < 3; ++i) body.particles[i].seed = {0.1 * static_cast<double>(i), 0, 0};
    body.bounds_max = {1, 1, 1};
    return body;
}

TEST(ThresholdCache, GivesBackWhatWasWrittenAndNothingElse) {
    const test::TemporaryFolder folder;
    const auto place = folder.path() / "deep" / "thresholds";
    EXPECT_TRUE(readCachedThresholds(place, 7).empty());
    writeCachedThreshold(place, 7, {1.5, 1.2, 1.9, 2.5, 4, 0.03});
    const auto found = readCachedThresholds(place, 7);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].share, 1.5);
    EXPECT_EQ(found[0].lowest, 1.2);
    EXPECT_EQ(found[0].highest, 1.9);
    EXPECT_EQ(found[0].critical_velocity, 2.5);
    EXPECT_EQ(found[0].packings, 4u);
    EXPECT_EQ(found[0].tolerance, 0.03);
    EXPECT_TRUE(readCachedThresholds(place, 8).empty());
    EXPECT_TRUE(readCachedThresholds({}, 7).empty());
}

TEST(ThresholdCache, KeepsOneMeasurementAStrength) {
    const test::TemporaryFolder folder;
    for (const double critical : {4.0, 1.0, 2.0, 4.01}) {
        CachedThreshold measured;
        measured.share = 1 / critical;
        measured.critical_velocity = critical;
        writeCachedThreshold(folder.path(), 7, measured);
    }
    const auto found = readCachedThresholds(folder.path(), 7);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].critical_velocity, 1);
    EXPECT_EQ(found[1].critical_velocity, 2);
    EXPECT_EQ(found[2].critical_velocity, 4.01);
    ASSERT_NE(measuredAt(found, 1.995), nullptr);
    EXPECT_EQ(measuredAt(found, 1.995)->critical_velocity, 2);
    EXPECT_EQ(measuredAt(found, 3), nullptr);
}

TEST(ThresholdCache, TheLastStrengthFoundForAVelocityIsTheOne) {
    const test::TemporaryFolder folder;
    for (const double critical : {4.0, 5.0, 9.0}) {
        CachedThreshold measured;
        measured.share = 1.2;
        measured.critical_velocity = critical;
        measured.break_at = critical < 6 ? 6 : 11;
        writeCachedThreshold(folder.path(), 7, measured);
    }
    const auto found = readCachedThresholds(folder.path(), 7);
    ASSERT_EQ(found.size(), 3u);
    ASSERT_NE(foundFor(found, 6.01), nullptr);
    EXPECT_EQ(foundFor(found, 6.01)->critical_velocity, 5);
    ASSERT_NE(foundFor(found, 11), nullptr);
    EXPECT_EQ(foundFor(found, 11)->critical_velocity, 9);
    EXPECT_EQ(foundFor(found, 7), nullptr);
    EXPECT_EQ(found[0].break_at, 0);
}

CachedThresholds measuredTwice(double weaker, double stronger) {
    CachedThresholds measured(2);
    measured[0].critical_velocity = 2;
    measured[0].share = weaker;
    measured[1].critical_velocity = 4;
    measured[1].share = stronger;
    return measured;
}

TEST(ThresholdCache, OneMeasurementIsTakenAsProportional) {
    CachedThresholds measured(1);
    measured[0].critical_velocity = 2;
    measured[0].share = 0.5;
    EXPECT_NEAR(shareAt(measured, 7), 0.5, 1e-12);
    EXPECT_NEAR(criticalVelocityAt(measured, 3), 6, 1e-12);
}

TEST(ThresholdCache, BetweenMeasurementsThresholdAndStrengthFollowTheSamePowerLaw) {
    // v_th = v_c^0.6: share v_c^-0.4. Inside, at the ends and beyond them.
    const auto measured = measuredTwice(std::pow(2, -0.4), std::pow(4, -0.4));
    for (const double critical : {1.0, 2.0, 2.7, 4.0, 9.0}) {
        EXPECT_NEAR(shareAt(measured, critical), std::pow(critical, -0.4), 1e-9) << critical;
        EXPECT_NEAR(criticalVelocityAt(measured, std::pow(critical, 0.6)), critical, 1e-9) << critical;
    }
}

TEST(ThresholdCache, WhatScatterTurnedRoundIsNotFollowedBeyondItsEnds) {
    const auto measured = measuredTwice(1, 0.4);  // 2 m/s at 2, 1.6 m/s at 4
    EXPECT_GT(criticalVelocityAt(measured, 3), 4);
    EXPECT_NEAR(criticalVelocityAt(measured, 1), 0.5, 1e-9) << "v_th no flatter than the root of v_c";
    const auto steep = measuredTwice(1, 2);  // 2 m/s at 2, 8 m/s at 4
    EXPECT_NEAR(criticalVelocityAt(steep, 16), 8, 1e-9) << "nor steeper than v_c";
}

TEST(ThresholdCache, ADamagedFileCountsAsNone) {
    const test::TemporaryFolder folder;
    writeCachedThreshold(folder.path(), 7, {1.5, 1.2, 1.9, 2.5, 4, 0.03});
    for (const char* text :
         {"", "{\"measured\": [{\"share\": 1", "{\"measured\": [{\"share\": \"x\"}]}", "[]"}) {
        folder.write("0000000000000007.json", text);
        EXPECT_TRUE(readCachedThresholds(folder.path(), 7).empty()) << text;
    }
}

TEST(ThresholdCache, APlaceThatCannotBeWrittenLosesNoMeasurement) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "0000000000000007.json");  // where the file would be
    EXPECT_TRUE(readCachedThresholds(folder.path(), 7).empty());
    EXPECT_NO_THROW(writeCachedThreshold(folder.path(), 7, {1.5, 1.2, 1.9, 2.5, 4, 0.03}));
    folder.write("plain", "a file, not a folder");
    EXPECT_NO_THROW(
        writeCachedThreshold(folder.path() / "plain" / "below", 7, {1.5, 1.2, 1.9, 2.5, 4, 0.03}));
}

TEST(ThresholdCache, TheKeyHangsOnWhatAThresholdHangsOn) {
    const Shot shot;
    const BreakableBody whole = body();
    const uint64_t key = thresholdKey(shot, whole);
    const auto differs = [&](auto&& change) {
        Shot other = shot;
        change(other);
        return thresholdKey(other, whole) != key;
    };
    EXPECT_TRUE(differs([](Shot& s) { s.material.tough_cells = 7; }));
    EXPECT_TRUE(differs([](Shot& s) { s.material.beta = 0.5; }));
    EXPECT_TRUE(differs([](Shot& s) { s.impact.ball_radius = 0.2; }));
    EXPECT_TRUE(differs([](Shot& s) { s.impact.height_fraction = 0.7; }));
    EXPECT_TRUE(differs([](Shot& s) { s.impact.kind = ImpactKind::kDrop; }));
    EXPECT_TRUE(differs([](Shot& s) { s.seed = 2; }));
    EXPECT_TRUE(differs([](Shot& s) { s.wave_speed = 100; }));
    EXPECT_FALSE(differs([](Shot& s) { s.impact.velocity = 33; }));
    EXPECT_FALSE(differs([](Shot& s) { s.material.critical_velocity = 9; }));
    EXPECT_FALSE(differs([](Shot& s) { s.device = DeviceChoice::kCpu; }));
    BreakableBody moved = body();
    moved.particles[1].seed.y = 1e-3;
    EXPECT_NE(thresholdKey(shot, moved), key);
}

}  // namespace
}  // namespace demolish
