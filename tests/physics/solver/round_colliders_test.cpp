// SPDX-License-Identifier: Apache-2.0
// Spheres and capsules as what bodies fall on, against closed forms, and a collider's own friction and
// restitution.
#include <cmath>
#include <vector>

#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/impact_on_collider.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class RoundColliders : public OnEitherDevice {};

constexpr double kRadius = 0.1, kGravity = 9.81;  // m, of the ball; m/s^2

/// A ball whose lowest point is at `position`.
SceneSetup ballAt(const Double3& position, const std::vector<Collider>& colliders) {
    SceneSetup setup = freeBody(ballBody(kRadius));
    setup.bodies[0].position = position;
    setup.bodies[0].material.rolling_friction = 0;
    setup.params.colliders = colliders;
    setup.params.gravity = {0, -kGravity, 0};
    setup.params.substeps = 100;
    setup.params.step_safety = 0.1;
    return setup;
}
const Sphere kBall{0.5, {0, -0.5, 0}};
const Capsule kRod{0.5, {-1, -0.5, 0}, {1, -0.5, 0}};

double speedUp(Solver& solver) {
    solver.measure();
    return solver.stats().linear_momentum.y / solver.stats().mass;
}

/// Share of its speed that a ball gives back which comes down at 2 m/s.
double givenBack(const Collider& collider, double restitution) {
    SceneSetup setup = ballAt({0, 0.001, 0}, {collider});
    setup.bodies[0].material.restitution = restitution;
    setup.bodies[0].velocity = {0, -2, 0};
    setup.params.gravity = {};
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 6; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    return speedUp(*solver) / 2;
}

TEST_F(RoundColliders, OnTheirTopsABallBouncesAsOnAPlane) {
    const double on_plane = givenBack(Plane{}, 0.6);
    EXPECT_NEAR(on_plane, 0.6, 0.03);
    EXPECT_NEAR(givenBack(kBall, 0.6), on_plane, 1e-3);
    EXPECT_NEAR(givenBack(kRod, 0.6), on_plane, 1e-3);
}

TEST_F(RoundColliders, AColliderMayHaveARestitutionOfItsOwn) {
    Collider bouncy = Plane{}, ball = kBall;
    bouncy.restitution = ball.restitution = 0.9;
    EXPECT_EQ(givenBack(bouncy, 0.2), givenBack(Plane{}, 0.9));
    EXPECT_EQ(givenBack(ball, 0.2), givenBack(kBall, 0.9));
}

TEST_F(RoundColliders, AColliderMayHaveAFrictionOfItsOwn) {
    const double angle = std::atan(0.3);
    for (const double own : {0.1, 0.5}) {
        SceneSetup setup = freeBody(latticeBody(6, 2, 6, 0.05));
        setup.bodies[0].material.friction = own == 0.1 ? 0.5 : 0.1;
        setup.bodies[0].material.critical_velocity = 100;
        Collider slope = Plane{};
        slope.friction = own;
        setup.params.colliders = {Plane{{1, 0, 0}, -50}, slope};
        setup.params.gravity = {kGravity * std::sin(angle), -kGravity * std::cos(angle), 0};
        setup.params.substeps = 100;
        setup.params.frame_time = 0.25;
        auto solver = makeSolver(setup);
        for (int frame = 0; frame < 2; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const double speed = solver->stats().linear_momentum.x / solver->stats().mass;
        const double slides = kGravity * (std::sin(angle) - own * std::cos(angle)) * solver->stats().time;
        EXPECT_NEAR(speed, std::max(slides, 0.0), 0.01 * std::max(slides, 0.5)) << own;
    }
}

/// rad from the top of kBall, and m from its surface to that of the ball.
struct OnTop {
    double angle, gap;
};
OnTop onTop(Solver& solver) {
    const auto at = exportedFrame(solver, 1).particles[0].position;
    const double x = at.x, y = double(at.y) - kBall.position.y;
    return {std::atan2(x, y), std::hypot(x, y) - kBall.radius - kRadius};
}
/// A ball that begins to come down from a little beside the top.
SceneSetup besideTheTop(double angle, double friction) {
    const double away = kBall.radius + kRadius;
    SceneSetup setup = ballAt({away * std::sin(angle), away * std::cos(angle) - away, 0}, {kBall});
    setup.params.colliders[0].friction = friction;
    setup.params.ledger = false;
    return setup;
}

/// v^2 = 2 g (R + r) (cos first - cos now), of which a ball that rolls turns two sevenths into spin.
TEST_F(RoundColliders, OffTheTopABallSlidesOrRollsAsFastAsItsFallSays) {
    for (const bool rolls : {false, true}) {
        auto solver = makeSolver(besideTheTop(0.15, rolls ? 1.5 : 0));
        while (onTop(*solver).angle < 0.6) ASSERT_EQ(solver->advanceSubsteps(10), StepStatus::kOk);
        solver->measure();
        const Double3 p = solver->stats().linear_momentum;
        const double speed = std::hypot(p.x, p.y) / solver->stats().mass;
        const double fall = (kBall.radius + kRadius) * (std::cos(0.15) - std::cos(onTop(*solver).angle));
        EXPECT_NEAR(speed / std::sqrt(2 * kGravity * fall * (rolls ? 5.0 / 7 : 1)), 1, 0.015) << rolls;
    }
}

/// Where the weight no longer turns it round the sphere: cos = 2/3 of the first one.
TEST_F(RoundColliders, WithoutFrictionItLeavesTheSphereAtTwoThirdsOfItsHeight) {
    auto solver = makeSolver(besideTheTop(0.15, 0));
    double last_touch = 0;
    for (OnTop now = onTop(*solver); now.gap < 0.02; now = onTop(*solver)) {
        if (now.gap <= 0) last_touch = now.angle;
        ASSERT_EQ(solver->advanceSubsteps(5), StepStatus::kOk);
    }
    EXPECT_NEAR(std::cos(last_touch), 2.0 / 3 * std::cos(0.15), 0.02);
}

/// Two rods side by side, their middles 0.5 m apart.
std::vector<Collider> groove() {
    return {Capsule{0.2, {-0.25, 0, -1}, {-0.25, 0, 1}}, Capsule{0.2, {0.25, 0, -1}, {0.25, 0, 1}}};
}

TEST_F(RoundColliders, ABallComesToRestInTheGrooveOfTwoCapsules) {
    SceneSetup setup = ballAt({0.03, 0.1, 0}, groove());
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 180; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const auto at = exportedFrame(*solver, 1).particles[0].position;
    EXPECT_NEAR(at.x, 0, 1e-3);
    EXPECT_NEAR(at.y, std::sqrt(0.3 * 0.3 - 0.25 * 0.25), 1e-3);
    solver->measure();
    EXPECT_LT(solver->stats().energy.kinetic, 1e-4 * solver->stats().mass);
}

/// A cube of 0.2 m on its corners: it lies on both rods and in the end asleep.
TEST_F(RoundColliders, ACubeComesToRestInTheGroove) {
    for (const bool hand_over : {false, true}) {
        SceneSetup setup = with(freeBody(latticeBody(4, 4, 4, 0.05)), {hand_over, hand_over});
        setup.bodies[0].material.critical_velocity = 20;
        setup.bodies[0].position = {0.002, 0.14, 0};
        setup.params.gravity = {0, -kGravity, 0};
        setup.params.colliders = groove();
        setup.params.substeps = 100;
        auto solver = makeSolver(setup);
        for (int frame = 0; frame < 120; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        EXPECT_EQ(solver->stats().bonds_broken, 0u);
        solver->measure();
        EXPECT_LT(solver->stats().energy.kinetic, 1e-4 * solver->stats().mass) << hand_over;
        for (const ParticleInstance& particle : exportedFrame(*solver, 64).particles)
            EXPECT_GT(particle.position.y, -0.1) << "it has not fallen through";
    }
}

TEST_F(RoundColliders, TheBooksCloseThroughAnImpactOnThem) {
    for (const Collider& collider : {Collider(kBall), Collider(kRod)})
        for (const bool hand_over : {false, true})
            EXPECT_LT(bookErrorOfImpactOn(collider, hand_over), 0.03) << hand_over;
}

/// Bonds that rest wake before a hard landing on a sphere.
TEST_F(RoundColliders, ABodyThatFallsOntoASphereWakes) {
    SceneSetup setup = with(freeBody(latticeBody(4, 4, 4, 0.05)), {true, true});
    setup.bodies[0].material.critical_velocity = 9;  // so that the landing wakes it and breaks nothing
    setup.bodies[0].position = {0, 0.5, 0};
    setup.params.gravity = {0, -kGravity, 0};
    setup.params.colliders = {kBall};
    setup.params.substeps = 100;
    auto solver = makeSolver(setup);
    bool was_rigid = false, woke = false;
    double fastest_up = 0;  // m/s
    while (solver->stats().time < 0.45) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        was_rigid = was_rigid || solver->stats().bonded_particles == 0;
        woke = woke || (was_rigid && solver->stats().bonded_particles > 0);
        fastest_up = std::max(fastest_up, speedUp(*solver));
    }
    EXPECT_TRUE(woke);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_GT(fastest_up, 0) << "it bounces";
}

}  // namespace
}  // namespace demolish::tests
