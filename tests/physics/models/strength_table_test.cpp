// SPDX-License-Identifier: Apache-2.0
// Thresholds of spheres and of the four models with the solver itself, beside the sheets' prototype
// (models.md E.2). Slow.
#include <cmath>

#include "tests/physics/models/packed_body.h"
#include "tests/physics/models/sheet_fits.h"
#include "tests/physics/models/shots.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class StrengthTable : public OnEitherDevice {};

/// beta that makes the threshold of a dropped 1 m sphere v_c: mean over packings.
double betaOfSphere(uint32_t particles, uint32_t cells) {
    constexpr int kPackings = 4;
    const double guess = cells == 0 ? calibratedBeta(diameterOverSpacing(particles))
                                    : calibratedBetaToughCells(diameterOverSpacing(particles));
    double sum = 0;
    for (uint64_t seed = 1; seed <= kPackings; ++seed) {
        const auto body = sphereBody(1, particles, seed);
        sum += thresholdSpeed(
            [&](double speed) {
                Material material = sheetMaterial(1, cells);
                material.beta = guess;
                return dropped(body, material, 100, {}, speed);
            },
            0.6, 1.8, 6);
    }
    return guess * kPackings / sum;
}

TEST_F(StrengthTable, BetaOfSpheres) {
    for (const uint32_t particles : {500u, 1000u})
        for (const uint32_t cells : {0u, 40u}) {
            const double d = diameterOverSpacing(particles),
                         sheet = cells == 0 ? calibratedBeta(d) : calibratedBetaToughCells(d);
            const double measured = betaOfSphere(particles, cells);
            printf("N %u K %u: beta %.3f sheet %.3f\n", particles, cells, measured, sheet);
            EXPECT_NEAR(measured / sheet, 1, 0.25) << particles << " particles, " << cells << " cells";
        }
}

struct Row {
    const char* model;
    double height, ball;  ///< m; ball radius, 0: dropped tilted
    uint32_t substeps;
    ThresholdCase which;
};

TEST_F(StrengthTable, ThresholdsOfTheModels) {
    const Row rows[] = {{"rabbit", 0.348, 0, 300, ThresholdCase::kRabbitDrop},
                        {"rabbit", 0.348, 0.0275, 300, ThresholdCase::kRabbitBall},
                        {"vase", 0.5, 0, 300, ThresholdCase::kVaseDrop},
                        {"column", 2.3, 0.12, 200, ThresholdCase::kColumnBall},
                        {"wolf", 1.05, 0.08, 300, ThresholdCase::kWolfBall}};
    for (const Row& row : rows) {
        const auto body = modelBody(row.model, row.height, 1500, 1);
        const double expected = thresholdFactor(row.which);
        const double measured = thresholdSpeed(
            [&](double speed) {
                const Material material = sheetMaterial(1, 50);
                if (row.ball > 0) return hitByBall(body, material, row.substeps, row.ball, speed);
                return dropped(body, material, row.substeps, {0.3, 0, 0.4}, speed);
            },
            expected / 2.5, expected * 2.5, 5);
        printf("%s ball %g: %.3f sheet %.3f\n", row.model, row.ball, measured, expected);
        EXPECT_NEAR(std::log(measured / expected), 0, std::log(1.5)) << row.model;
    }
}

}  // namespace
}  // namespace demolish::tests
