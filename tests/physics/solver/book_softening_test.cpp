// SPDX-License-Identifier: Apache-2.0
// What faces of a broken bond lose when a fragment at one of their ends becomes rigid (architecture 9).
#include "sim_cuda/kernels/book_softening.h"

#include "sim_cuda/solver/rigid_params.h"
#include "tests/physics/solver/pair_fixture.h"

namespace demolish::tests {
namespace {

/// Two fragments, the lower one rigid or bonded before, that are rigid now; their faces are pressed.
class Softening : public Pair {
  protected:
    static constexpr double kOverlap = 0.01 * kSize;

    Softening() {
        setState(PairState::kBroken);
        setDistance(kSize - kOverlap);
    }
    /// J
    double booked(Regime lower_before) {
        constexpr uint32_t kStride = 10;
        const uint32_t label[] = {0, 1}, regime[] = {wordOf(Regime::kRigid), wordOf(Regime::kRigid)},
                       former[] = {wordOf(lower_before), wordOf(Regime::kBonded)};
        MeasureEnergy<double> bonded{data_.arrays(lists_.contacts()), {}, params_, {}, {}, {}, {}, true};
        MeasureEnergy<double> rigid = bonded;
        rigid.params = rigidParams(params_, kStride, kStride);
        soft_ = rigid.params.face_cap * tables_.mass[0] / 2;
        std::vector<Vec4<double>> ledger(2);
        const BookSoftening<double> kernel{bonded,     bonded,      rigid,       {},
                                           {label, 2}, {regime, 2}, {former, 2}, {ledger.data(), 2}};
        for (uint32_t i = 0; i < 2; ++i) kernel(i);
        return ledger[0].x + ledger[1].x;
    }
    double stiff() const { return tables_.slots[0].stiffness; }

    double soft_ = 0;  ///< N/m, of faces in contact steps
};

TEST_F(Softening, TakesWhatStifferFacesHeld) {
    keepTouch(kNeverSoftened);
    for (const Regime before : {Regime::kRigid, Regime::kBonded}) {
        const double lost = booked(before);
        ASSERT_LT(soft_, 0.1 * stiff());
        EXPECT_NEAR(lost, 0.5 * (stiff() - soft_) * kOverlap * kOverlap, 1e-6 * lost);
    }
}

/// Substeps see a rigid cell half a contact step back, and apart: no contact has ever taken in its overlap.
TEST_F(Softening, TakesNothingFromFacesThatHoldNothingBesideWhatWasRigid) {
    EXPECT_EQ(booked(Regime::kRigid), 0);
}

/// What was bonded on both sides until now has just broken: its faces keep their energy (physics A.6).
TEST_F(Softening, TakesWhatFacesKeepWhoseBondHasJustBroken) {
    const double lost = booked(Regime::kBonded);
    EXPECT_NEAR(lost, 0.5 * (stiff() - soft_) * kOverlap * kOverlap, 1e-6 * lost);
}

TEST_F(Softening, TakesNothingTwice) {
    keepTouch(7);
    EXPECT_EQ(booked(Regime::kRigid), 0);
    EXPECT_EQ(booked(Regime::kBonded), 0);
}

}  // namespace
}  // namespace demolish::tests
