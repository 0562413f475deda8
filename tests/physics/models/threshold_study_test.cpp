// SPDX-License-Identifier: Apache-2.0
// Strength means the same at every particle size and step (models.md E.2). Slow: on the CPU few bodies and
// sizes, on the GPU all six at N = 1,000, 3,000 and 10,000. The sums of the study are printed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/physics/models/threshold_study.h"
#include "tests/physics/solver/solver_under_test.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::tests {
namespace {

class ThresholdStudy : public OnEitherDevice {
  protected:
    StudyResult run(const StudyShot& shot, uint32_t particles, uint32_t packings, uint32_t finer_steps,
                    double tolerance = 0.06) {
        const StudyResult result = runCase(
            {&shot, particles, packings, tolerance, {.on_gpu = asksForGpu(), .finer_steps = finer_steps}});
        std::printf("%s %s N %u, steps x%u: v_th/v_c %.3f, spread %.2f\n", shot.body.c_str(),
                    shot.kind.c_str(), particles, finer_steps, result.threshold.share, result.spread());
        return result;
    }
    bool isChosen(const StudyShot& shot) const {
        return asksForGpu() || shot.body == "sphere" || shot.body == "rabbit";
    }
    test::TemporaryFolder folder_;
};

TEST_F(ThresholdStudy, TheSameBodyBreaksAtTheSameSpeedAtEverySize) {
    const std::vector<uint32_t> sizes =
        asksForGpu() ? std::vector<uint32_t>{1000, 3000, 10000} : std::vector<uint32_t>{500, 1500};
    const uint32_t packings = asksForGpu() ? 6 : 4;
    for (const StudyShot& shot : studyShots(folder_.path())) {
        if (!isChosen(shot)) continue;
        std::vector<StudyResult> results;
        double mean = 0;
        for (const uint32_t particles : sizes) {
            results.push_back(run(shot, particles, packings, 1));
            mean += results.back().threshold.share / static_cast<double>(sizes.size());
        }
        for (const StudyResult& result : results) {
            // A mean of few packings is itself uncertain by this much.
            const double doubt = result.spread() / std::sqrt(packings);
            EXPECT_NEAR(result.threshold.share / mean, 1, 0.15 + doubt)
                << shot.body << ' ' << shot.kind << " D/h " << result.size_ratio;
        }
    }
}

TEST_F(ThresholdStudy, TwiceTheSubstepsAtTheSameStiffnessChangeNothingForADrop) {
    for (const StudyShot& shot : studyShots(folder_.path())) {
        if (!isChosen(shot) || shot.kind != "drop") continue;
        const uint32_t particles = 1000, packings = asksForGpu() ? 12 : 4;
        // Brackets must be narrower than what is asked.
        const double usual = run(shot, particles, packings, 1, 0.03).threshold.velocity,
                     fine = run(shot, particles, packings, 2, 0.03).threshold.velocity;
        EXPECT_NEAR(fine / usual, 1, 0.05) << shot.body;
    }
}

}  // namespace
}  // namespace demolish::tests
