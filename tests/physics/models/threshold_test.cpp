// SPDX-License-Identifier: Apache-2.0
// Strength means the same at any stiffness, and twice the strength bears twice the speed (physics.md D 25).
#include <cmath>

#include "sim_cuda/physics/softening.h"
#include "tests/physics/models/packed_body.h"
#include "tests/physics/models/shots.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Threshold : public OnEitherDevice {
  protected:
    static constexpr int kPackings = 4;
    void SetUp() override {
        OnEitherDevice::SetUp();
        for (uint64_t seed = 1; !IsSkipped() && seed <= kPackings; ++seed)
            bodies_.push_back(boxBody({1, 1, 1}, 400, seed));
    }
    /// m/s, mean over the packings, of a cube dropped flat: a ball lands on corners of fewer cells the
    /// stiffer it is, and bears more.
    double mean(uint32_t substeps, double beta) const {
        double sum = 0;
        for (const auto& body : bodies_)
            sum += thresholdSpeed(
                [&](double speed) {
                    Material material = sheetMaterial(1, 0);
                    material.beta = beta;
                    return dropped(body, material, substeps, {}, speed);
                },
                0.8 * beta / 0.58, 3.2 * beta / 0.58, 6);
        return sum / kPackings;
    }
    std::vector<std::shared_ptr<const BreakableBody>> bodies_;
};

TEST_F(Threshold, StaysWithTwiceTheSubstepsAndDoublesWithTheStrength) {
    const double usual = mean(100, 0.58), finer = mean(200, 0.58), stronger = mean(100, 1.16);
    RecordProperty("threshold_mm_per_s", static_cast<int>(1000 * usual));
    EXPECT_NEAR(finer / usual, 1, 0.03);
    EXPECT_NEAR(stronger / usual, 2, 0.06);
}

class WallStrength : public OnEitherDevice {
  protected:
    /// Strength in force over beta rho c v_c.
    static double shareOf(const Double3& sides, uint32_t particles) {
        const Material material = sheetMaterial(2, 0);
        const auto solver = makeSolver(dropped(boxBody(sides, particles, 1), material, 100, {}, 1));
        const SofteningReport& softening = solver->softening();
        return softening.strength / bondStrength(material.beta, material.density, softening.wave_speed, 2);
    }
};

TEST_F(WallStrength, OneLayerOfCellsIsWeakenedAThickBodyIsNot) {
    EXPECT_NEAR(shareOf({1, 0.05, 1}, 170), thinWallShare(2 * 0.05 / (2.2 * std::cbrt(0.05 / 170))), 0.002);
    EXPECT_LT(shareOf({1, 0.05, 1}, 170), 0.85);
    EXPECT_NEAR(shareOf({1, 0.3, 1}, 400), 1, 1e-12);
}

}  // namespace
}  // namespace demolish::tests
