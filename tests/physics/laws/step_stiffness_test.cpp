// SPDX-License-Identifier: Apache-2.0
// Contact steps make no contact stiffer than substeps would (decisions/contact_laws.md): at a hand-over its
// overlap stays.
#include <gtest/gtest.h>

#include "sim_cuda/kernels/rigid_step.h"
#include "sim_cuda/kernels/touch_slots.h"
#include "sim_cuda/solver/rigid_params.h"

namespace demolish {
namespace {

constexpr double kMass = 0.3, kRadius = 0.05, kOverlap = 1e-4, kInertia = 0.4 * kMass * kRadius * kRadius;

StepParams<double> substep() {
    StepParams<double> params;
    params.dt = params.drift = 4e-5;
    params.stiffness_cap = kContactStiffnessShare / (params.dt * params.dt);
    return params;
}
ParticleConstants<double> alone() {
    return {1 / kMass, 1 / kInertia, kRadius, kRadius};
}
/// As contact steps see it: so many times its own mass stands behind it.
ParticleConstants<double> shared(double times) {
    return {1 / (times * kMass), 1 / kMass, kRadius, kRadius};
}
ParticleConstants<double> carried(double times) {
    RigidBody body;
    body.contact_share = float(1 / times);
    return carriedConstants(body, shared(times), alone());
}
/// N/m; `stiffness`: of the linear law, N/m.
template <StepKind kStep>
double stiffnessOf(const StepParams<double>& params, double stiffness, const PairInertia<double>& against) {
    PairLaw<double> pair;
    pair.stiffness = stiffness;
    return contactTouchLaw<kStep>(pair, params, kOverlap, kRadius / 2, against,
                                  softestOfPair<kStep>(params, against, 0.0))
        .stiffness;
}

TEST(StepStiffness, NeverGrowsInContactStepsHoweverHeavyTheFragment) {
    const StepParams<double> params = substep(), contact_step = rigidParams(params, 10, 10);
    for (const double law : {1e4, 1e6, 1e8, 1e12}) {
        const double in_substeps =
            stiffnessOf<StepKind::kSubstep>(params, law, pairInertia(alone(), alone()));
        for (const double times : {1.0, 10.0, 90.0, 200.0, 1e4, 1e8}) {
            const PairInertia<double> both = pairInertia(shared(times), shared(times)),
                                      one = pairInertia(alone(), carried(times));
            EXPECT_LE(stiffnessOf<StepKind::kContact>(contact_step, law, both), in_substeps * (1 + 1e-12))
                << law << ", " << times;
            EXPECT_LE(stiffnessOf<StepKind::kSubstep>(params, law, one), in_substeps * (1 + 1e-12))
                << law << ", " << times;
        }
    }
}

TEST(StepStiffness, IsWhatTheStepBearsOfALightFragment) {
    const StepParams<double> params = substep(), contact_step = rigidParams(params, 10, 10);
    const PairInertia<double> both = pairInertia(shared(2), shared(2));
    EXPECT_NEAR(stiffnessOf<StepKind::kContact>(contact_step, 1e12, both), contact_step.stiffness_cap * kMass,
                1e-9 * contact_step.stiffness_cap * kMass);
}

}  // namespace
}  // namespace demolish
