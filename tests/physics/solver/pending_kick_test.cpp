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

    void wake(double overlap) { gather(overlap, Regime::kBonded, false); }
    /// Both cells wake. The upper one belongs to what a path leads along the line between them (m/s).
    void wakeHeld(double overlap, double led) {
        now().velocity[1].x = led;
        gather(overlap, Regime::kRigid, true);
    }
    /// `former`: of the upper cell.
    void gather(double overlap, Regime former_of_upper, bool held) {
        setDistance(kSize - overlap);
        const uint32_t label[] = {0, 1}, regime[] = {wordOf(Regime::kBonded), wordOf(Regime::kBonded)},
                       former[] = {wordOf(Regime::kRigid), wordOf(former_of_upper)};
        RigidBody body[2];
        for (uint32_t i = 0; i < 2; ++i) {
            body[i].centre = asDouble(xyz(now().position[i]));
            body[i].inverse_mass = 1 / tables_.mass[i];
            body[i].inverse_inertia = {1, 1, 1, 0, 0, 0};
        }
        if (held) body[1].inverse_mass = 0;
        std::vector<uint64_t> sums(12);
        RigidWork work;
        work.body = {body, 2};
        work.label = {label, 2};
        const PendingKicks pending{{label, 2}, {regime, 2},       {former, 2},
                                   {body, 2},  {sums.data(), 12}, 0.5 * (kStride - 1) * params_.dt};
        const StepParams<double> contact_step = rigidParams(params_, kStride, kStride);
        soft_ = contact_step.face_cap * tables_.mass[0] / 2;
        SubstepArrays<double> arrays = data_.arrays(lists_.contacts());
        std::vector<Vec4<double>> carried_tally(8);
        arrays.carried_tally = {carried_tally.data(), carried_tally.size()};
        const GatherPendingKick<true, double> kernel{arrays, contact_step, params_, pending, work};
        for (const uint32_t slot : {0, 1}) pending(slot);
        for (uint32_t i = 0; i < 2; ++i) kernel(i);
        kicked_ = pending.isKicked(0);
        given_ = tables_.mass[0] * pending.velocity(0).x;
        held_moves_ = pending.isKicked(1);
        work_ = bookedWork(data_.ledger.span()[1]);
        damped_ = bookedDamping(data_.ledger.span()[1]);
    }
    double softest(uint32_t end) const { return softestOf(data_.bonds.spring.view()[end]); }

    double soft_ = 0;  ///< N/m, of faces in contact steps
    bool kicked_ = false, held_moves_ = false;
    double given_ = 0;              ///< N s, to the lower cell
    double work_ = 0, damped_ = 0;  ///< J, booked for the upper one
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

/// Else what a path squeezes would have taken in the way of half a contact step, and nobody would have done
/// the work: 9 % of all that a wall had brought in one decision.
TEST_F(PendingKick, WhatIsLedHasStillToDoTheWorkOfHalfAStep) {
    constexpr double kLed = -0.1, kOverlap = 0.01 * kSize;
    keepTouch(kNeverSoftened);
    wakeHeld(kOverlap, kLed);
    const double force = tables_.slots[0].stiffness * kOverlap, time = 0.5 * (kStride - 1) * params_.dt;
    EXPECT_LT(given_, -force * time) << "spring and damper push";
    EXPECT_NEAR(given_, -force * time, 0.3 * force * time);
    EXPECT_FALSE(held_moves_);
    EXPECT_NEAR(work_, given_ * kLed, 1e-9 * work_);
    EXPECT_GT(damped_, 0);
    EXPECT_NEAR(damped_, (-given_ - force * time) * -kLed, 1e-6 * work_);
}

}  // namespace
}  // namespace demolish::tests
