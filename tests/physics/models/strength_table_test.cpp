// SPDX-License-Identifier: Apache-2.0
// What the table of assets/strength predicts is what the solver gives: spheres with and without tough cells,
// and the six bodies with the shots that it was measured with. Slow.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "app/session/threshold_table.h"
#include "tests/physics/models/threshold_study.h"
#include "tests/physics/solver/solver_under_test.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::tests {
namespace {

constexpr double kWithin = 0.15;

class StrengthTable : public OnEitherDevice {
  protected:
    StudyResult run(const StudyShot& shot, uint32_t particles, uint32_t packings) const {
        constexpr double kTolerance = 0.06;
        return runCase({&shot, particles, packings, kTolerance, {.on_gpu = asksForGpu()}});
    }
    /// A mean of few packings is itself uncertain by `scatter` over their root.
    static void expectAsPredicted(const std::string& what, double measured, double predicted, double scatter,
                                  uint32_t packings) {
        std::printf("%s: %.3f, table %.3f\n", what.c_str(), measured, predicted);
        EXPECT_NEAR(measured / predicted, 1, kWithin + scatter / std::sqrt(packings)) << what;
    }
    const ThresholdTable& table_ = ThresholdTable::ofAssets();
    test::TemporaryFolder folder_;
};

TEST_F(StrengthTable, BetaOfSpheres) {
    constexpr uint32_t kPackings = 4;
    for (const double tough : {1.0, 2.0, 3.0, 4.0})
        for (const uint32_t particles : {300u, 1000u}) {
            const StudyShot shot = sphereDrop(folder_.path(), tough);
            const StudyResult result = run(shot, particles, kPackings);
            const Material& material = shot.shot.material;
            expectAsPredicted("beta, N " + std::to_string(particles) + ", ci " + std::to_string(tough),
                              material.beta / result.threshold.share,
                              table_.sphereBeta(material, result.size_ratio), result.spread(), kPackings);
        }
}

TEST_F(StrengthTable, ThresholdsOfTheModels) {
    constexpr uint32_t kPackings = 8, kParticles = 1000;
    for (const StudyShot& shot : studyShots(folder_.path())) {
        const StudyResult result = run(shot, kParticles, kPackings);
        const ImpactFeatures features{result.size_ratio, 1, result.ball_mass / result.body_mass};
        const auto predicted = table_.predict(shot.shot.strength_row, shot.shot.material, features);
        EXPECT_TRUE(predicted.is_known) << shot.body;
        expectAsPredicted(shot.body + ' ' + shot.kind, result.threshold.share, predicted.share,
                          predicted.scatter - 1, kPackings);
    }
}

}  // namespace
}  // namespace demolish::tests
