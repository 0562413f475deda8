// What was measured is found again, for the same body and setting alone.
#include "app/session/threshold_cache.h"

#include <gtest/gtest.h>

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
    EXPECT_FALSE(readCachedThreshold(place, 7));
    writeCachedThreshold(place, 7, {1.5, 1.2, 1.9, 2.5, 4, 0.03});
    const auto found = readCachedThreshold(place, 7);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->share, 1.5);
    EXPECT_EQ(found->lowest, 1.2);
    EXPECT_EQ(found->highest, 1.9);
    EXPECT_EQ(found->critical_velocity, 2.5);
    EXPECT_EQ(found->packings, 4u);
    EXPECT_EQ(found->tolerance, 0.03);
    EXPECT_FALSE(readCachedThreshold(place, 8));
    EXPECT_FALSE(readCachedThreshold({}, 7));
}

TEST(ThresholdCache, ADamagedFileCountsAsNone) {
    const test::TemporaryFolder folder;
    writeCachedThreshold(folder.path(), 7, {1.5, 1.2, 1.9, 2.5, 4, 0.03});
    for (const char* text : {"", "{\"share\": 1", "{\"share\": \"x\"}", "[]"}) {
        folder.write("0000000000000007.json", text);
        EXPECT_FALSE(readCachedThreshold(folder.path(), 7)) << text;
    }
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
