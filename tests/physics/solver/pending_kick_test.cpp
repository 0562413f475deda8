// SPDX-License-Identifier: Apache-2.0
// Faces of a broken bond between a cell that wakes and one that has been moved with its bonds (architecture
// 9).
#include "sim_cuda/kernels/pending_kick.h"

#include "sim_cuda/solver/rigid_params.h"
#include "tests/physics/solver/pair_fixture.h"

namespace demolish::tests {
namespace {

constexpr uint32_t kStride = 10;  ///< substeps of a contact step

/// The lower cell wakes. Substeps have seen it half a contact step back.
class PendingKick : public Pair {
  protected:
    PendingKick() { setState(PairState::kBroken); }

    void wake(double overlap) {
        setDistance(kSize - overlap);
        const uint32_t label[] = {0, 1}, regime[] = {wordOf(Regime::kBonded), wordOf(Regime::kBonded)},
                       former[] = {wordOf(Regime::kRigid), wordOf(Regime::kBonded)};
        RigidBody body[2];
        body[0].centre = asDouble(xyz(now().position[0]));
        body[0].inverse_mass = 1 / tables_.mass[0];
        body[0].inverse_inertia = {1, 1, 1, 0, 0, 0};
        std::vector<uint64_t> sums(12);
        RigidWork work;
        work.body = {body, 2};
        work.label = {label, 2};
        const PendingKicks pending{{label, 2}, {regime, 2},       {former, 2},
                                   {body, 2},  {sums.data(), 12}, 0.5 * (kStride - 1) * params_.dt};
        const StepParams<double> contact_step = rigidParams(params_, kStride, kStride);
        soft_ = contact_step.face_cap * tables_.mass[0] / 2;
        const GatherPendingKick<false, double> kernel{data_.arrays(lists_.contacts()), contact_step, params_,
                                                      pending, work};
        for (uint32_t i = 0; i < 2; ++i) kernel(i);
        kicked_ = pending.isKicked(0);
    }
    double softest(uint32_t end) const { return softestOf(data_.bonds.spring.view()[end]); }

    double soft_ = 0;  ///< N/m, of faces in contact steps
    bool kicked_ = false;
};

/// Else they would find themselves loaded with what neither cell has brought: half a percent of all energy
/// in a single decision of a needle that breaks as it lands.
TEST_F(PendingKick, FacesThatNothingHasSeenBeginAsSoftAsInAContactStep) {
    wake(0.1 * kSize);
    ASSERT_LT(soft_, 0.1 * tables_.slots[0].stiffness);
    for (uint32_t end = 0; end < 2; ++end) EXPECT_NEAR(softest(end), soft_, 1e-9 * soft_) << "end " << end;
    EXPECT_FALSE(kicked_) << "what goes on as it did has given all that it had to give";
}

TEST_F(PendingKick, FacesThatHaveTouchedGoOnAsTheyWere) {
    keepTouch(kNeverSoftened);
    wake(0.1 * kSize);
    for (uint32_t end = 0; end < 2; ++end) EXPECT_EQ(softest(end), 0);
}

/// That is as little as the bond held.
TEST_F(PendingKick, FacesThatAreHardlyPressedBeginAsTheyAre) {
    wake(1e-6 * kSize);
    for (uint32_t end = 0; end < 2; ++end) EXPECT_EQ(softest(end), 0);
}

}  // namespace
}  // namespace demolish::tests
