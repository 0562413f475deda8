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

/// Of a piece that touches a hard floor with one corner, `far` m from its centre: what spring and damper take
/// of its speed there in one contact step, over that speed, if it has come in by a whole step. `turns`: how
/// easily it turns, over a ball of that mass.
double takenByOneCorner(double far, double turns) {
    RigidBody body;
    body.inverse_mass = 1 / kMass;
    body.contacts = 1;
    body.standing = 1;
    const double easily = turns * 2.5 / (kMass * kRadius * kRadius);
    body.inverse_inertia = {easily, easily, easily, 0, 0, 0};
    const uint32_t label = 0;
    RigidWork work;
    work.body = {&body, 1};
    work.label = {&label, 1};
    OwnParticle<double> own;
    own.constants = {1 / kMass, 1 / kMass, kRadius, far};
    const StepParams<double> step = rigidParams(substep(), 10, 10);
    Pressed<double> at;
    at.normal = {0, 1, 0};
    at.arm = {far, 0, 0};
    at.depth = 1e-3;
    PairLaw<double> floor;
    floor.stiffness = 1e12;
    floor.damping = 10;
    const TurnsFragment<double> turned_with{work, {}, {}};
    const Turning<double> turning = turned_with(own, at);
    const TouchLaw<double> law = pressingLaw<StepKind::kContact>(floor, step, own, at, turning, {}, {});
    const double gives_way = body.inverse_mass + far * far * easily, dt = step.dt;
    return gives_way * dt * (law.elastic / at.depth * dt + law.normal_damping);
}
/// In contact steps. Slender cells have the inertia of balls, and turn easily under their corners.
TEST(StepStiffness, OneCornerDoesNotComeOffFasterThanItHasLanded) {
    for (const double far : {kRadius, 2 * kRadius, 5 * kRadius})
        for (const double turns : {0.5, 1.0, 3.0, 10.0}) {
            EXPECT_LE(takenByOneCorner(far, turns), 2) << far << ", " << turns;
            EXPECT_GT(takenByOneCorner(far, turns), 0.9) << far << ", " << turns;
        }
}

}  // namespace
}  // namespace demolish
