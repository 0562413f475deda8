// SPDX-License-Identifier: Apache-2.0
// A bond that is compressed and sheared until it breaks, in the solver's own substep: what it releases
// (physics.md D 21).
#include "sim_cuda/physics/bond_laws.h"
#include "tests/physics/solver/pair_fixture.h"

namespace demolish::tests {
namespace {

class BreakRelease : public Pair {
  protected:
    double kinetic() {
        double sum = 0;
        for (uint32_t i = 0; i < 2; ++i)
            sum += 0.5 * tables_.mass[i] * length2(xyz(now().velocity[i])) +
                   0.5 * tables_.inertia[i] * length2(xyz(now().spin[i]));
        return sum;
    }
    BondDeformation<double> deformation() {
        PairMotion<double> pair;
        pair.separation = xyz(now().position[1]) - xyz(now().position[0]);
        pair.rotation_i = asQuat(now().rotation[0]);
        pair.rotation_j = asQuat(now().rotation[1]);
        return bondDeformation(Vec3<double>{kSize, 0, 0}, pair);
    }
    BondStiffness<double> stiffness() const {
        const BondSlot& slot = tables_.slots[0];
        return roundBond(slot.stiffness, tables_.body[0].shear_ratio, slot.radius);
    }
    void approach(double closing, double shearing) {
        for (uint32_t i = 0; i < 2; ++i) {
            const double sign = i == 0 ? 1 : -1;
            now().velocity[i] = {sign * closing, sign * shearing, 0, 0};
        }
    }
    /// N, along x, on the first cube in the next substep.
    double pushInOneStep() {
        const double before = now().velocity[0].x;
        step();
        return (now().velocity[0].x - before) * tables_.mass[0] / params_.dt;
    }
};

TEST_F(BreakRelease, PiecesGetNoMoreThanTheBondStored) {
    params_.dt /= 10;  // the moment of the break is found to a tenth of a substep
    approach(0.4, 4);
    double stored = 0, before_break = 0, fastest = 0, total = kinetic();
    for (int n = 0; n < 20000 && state(0) != PairState::kContact; ++n) {
        const bool bonded = state(0) == PairState::kBonded;
        const double energy = bondEnergy(stiffness(), deformation()), motion = kinetic();
        step();
        if (bonded && state(0) == PairState::kBroken) {
            stored = energy;
            before_break = motion;
            EXPECT_LT(deformation().stretch, 0);  // it was pressed, and broke in shear
        }
        if (!bonded) fastest = std::max(fastest, kinetic());
    }
    ASSERT_EQ(state(0), PairState::kContact);
    ASSERT_GT(stored, 0);
    EXPECT_LE(fastest, before_break + 1.001 * stored);
    EXPECT_LE(fastest, total * 1.001);  // nor more than there was at the beginning
    EXPECT_EQ(state(1), PairState::kContact);
}

TEST_F(BreakRelease, TheNormalForceGoesOnAcrossTheStepThatBreaks) {
    params_.dt /= 5000;
    LawTables weak = buildLawTables(setup_, tables_, {});
    weak.body[0].beta_r = 0;
    weak.body[0].strength_unit /= 100;  // so small a shear that it hardly tilts the line of centres
    data_.uploadLaws(backend_, weak);
    approach(0.004, 0.04);
    double before = 0;
    while (state(0) == PairState::kBonded) before = pushInOneStep();
    const double after = pushInOneStep();
    ASSERT_EQ(state(0), PairState::kBroken);
    ASSERT_LT(before, 0);  // pushed back
    const double normal =
        -brokenRepulsion(tables_.slots[0].stiffness,
                         brokenOverlap(kSize, length(xyz(now().position[1]) - xyz(now().position[0]))));
    EXPECT_NEAR(after / normal, 1, 0.02);
    EXPECT_NEAR(after / before, 1, 0.02);
}

}  // namespace
}  // namespace demolish::tests
