// SPDX-License-Identifier: Apache-2.0
// Sizes follow N(> s) ~ s^-2.2, drawn from a table without powers; random places and directions are even.
#include "sim_cuda/effects/size_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/effects/debris_law.h"
#include "sim_cuda/effects/draws.h"

namespace demolish {
namespace {

TEST(SizeLaw, ManyDrawnSizesHaveItsSlope) {
    const auto table = sizeQuantiles(kFinestGrain, kCoarsestGrain, kSizeExponent);
    const Span<const float> quantile(table.data(), table.size());
    Draws draws(1, 2);
    std::vector<double> sizes(200'000);
    for (double& size : sizes) size = sizeAt(quantile, draws.uniform());
    const auto larger = [&](double s) {
        return static_cast<double>(
            std::count_if(sizes.begin(), sizes.end(), [s](double size) { return size > s; }));
    };
    EXPECT_EQ(larger(kCoarsestGrain * 1.0001), 0);
    EXPECT_EQ(larger(kFinestGrain * 0.9999), sizes.size());
    const double slope = std::log(larger(0.12) / larger(0.04)) / std::log(0.12 / 0.04);
    EXPECT_NEAR(slope, -kSizeExponent, 0.15);  // the upper end bends it down a little
}

TEST(SizeLaw, TheTableIsTheLawAtItsEnds) {
    const auto table = sizeQuantiles(0.1, 1, 2);
    const Span<const float> quantile(table.data(), table.size());
    EXPECT_NEAR(sizeAt(quantile, 0), 1, 1e-6);
    EXPECT_NEAR(sizeAt(quantile, 0.9999999f), 0.1, 1e-3);
    for (const double u : {1e-4, 0.003, 0.1, 0.5, 0.9})
        EXPECT_NEAR(sizeAt(quantile, static_cast<float>(u)) / std::pow(1 + 99 * u, -0.5), 1, 0.01) << u;
}

TEST(Draws, HangOnTheNumberAloneAndAreEven) {
    EXPECT_EQ(Draws(3, 4).word(), Draws(3, 4).word());
    EXPECT_NE(Draws(3, 4).word(), Draws(3, 5).word());
    Draws draws(5, 6);
    Vec3<float> sum{};
    double mean = 0;
    for (int k = 0; k < 20'000; ++k) {
        const Vec3<float> d = draws.direction();
        EXPECT_NEAR(length(d), 1, 1e-5);
        sum = sum + d;
        mean += draws.uniform();
    }
    EXPECT_LT(length(sum) / 20'000, 0.02);
    EXPECT_NEAR(mean / 20'000, 0.5, 0.01);
}

TEST(DebrisLaw, AmountsOfAMaterialDoNotHangOnTheParticleSize) {
    // As many grains above 1 mm, and as much dust, whatever the spacing.
    Debris debris;
    for (const double h : {0.006, 0.012, 0.024}) {
        auto body = std::make_shared<BreakableBody>();
        body->spacing = h;
        BodyInstance instance;
        instance.body = body;
        const DebrisLaw law = debrisLaw(instance, {});
        EXPECT_NEAR(law.grit_per_m2 * std::pow(kFinestGrain * h / 1e-3, kSizeExponent) / debris.grit_per_m2,
                    1, 1e-4);
        const double disc = kPi * std::pow(kPuffRadius * h, 2);
        EXPECT_NEAR(law.puffs_per_m2 * law.puff_depth * disc / debris.dust_m2_per_m2, 1, 1e-4);
    }
}

TEST(DebrisLaw, NothingOfWhatIsNotWanted) {
    auto body = std::make_shared<BreakableBody>();
    body->spacing = 0.01;
    BodyInstance instance;
    instance.body = body;
    const DebrisLaw law = debrisLaw(instance, {.grit = 0, .dust = 0, .sparks = 0});
    EXPECT_EQ(law.grit_per_m2, 0);
    EXPECT_EQ(law.puffs_per_m2, 0);
    EXPECT_EQ(law.sparks, 0);
}

}  // namespace
}  // namespace demolish
