// Strength means the same at any stiffness, and twice the strength bears twice the speed (physics.md D 25).
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
            bodies_.push_back(sphereBody(1, 400, seed));
    }
    /// m/s, mean over the packings, of a sphere dropped on the floor.
    double mean(uint32_t substeps, double beta) const {
        double sum = 0;
        for (const auto& body : bodies_)
            sum += thresholdSpeed(
                [&](double speed) {
                    Material material = sheetMaterial(1, 0);
                    material.beta = beta;
                    return dropped(body, material, substeps, {}, speed);
                },
                0.6 * beta / 0.58, 1.8 * beta / 0.58, 6);
        return sum / kPackings;
    }
    std::vector<std::shared_ptr<const BreakableBody>> bodies_;
};

TEST_F(Threshold, StaysWithTwiceTheSubstepsAndDoublesWithTheStrength) {
    const double usual = mean(100, 0.58), finer = mean(200, 0.58), stronger = mean(100, 1.16);
    RecordProperty("threshold_mm_per_s", static_cast<int>(1000 * usual));
    EXPECT_NEAR(finer / usual, 1, 0.10);
    EXPECT_NEAR(stronger / usual, 2, 0.10);
}

}  // namespace
}  // namespace demolish::tests
