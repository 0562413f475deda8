// SPDX-License-Identifier: Apache-2.0
// Bodies that begin against each other touch with their outsides: what stands stays upright, dry walls stand,
// and both ends of a touch agree, whatever the bodies are made of.
#include <cmath>

#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/pair_fixture.h"
#include "tests/physics/solver/placed_body.h"
#include "tests/physics/solver/regimes_of.h"

namespace demolish::tests {
namespace {

class FacingBodies : public OnEitherDevice {};

constexpr double kLength = 0.24, kHeight = 0.071, kDepth = 0.115;  // m, of a brick

void makeUnlike(BodyInstance& body) {
    body.material.density *= 1.5;
    body.material.friction = 0.25;
    body.material.restitution = 0.5;
    body.material.shear_ratio = 0.25;
    body.material.damping_ratio = 0.2;
}

/// Of a body, from where its particles were: rad by which its upper half has gone sideways over its lower
/// half; m that the lower half has come down.
struct Stance {
    double lean = 0, sunk = 0;
};
Stance stanceOf(const BodyInstance& instance, const ParticleInstance* now) {
    struct Half {
        double count = 0, x = 0, y = 0, z = 0, height = 0;
    } half[2];
    const auto& particles = instance.body->particles;
    double middle = 0;
    for (const Particle& p : particles) middle += p.seed.y / static_cast<double>(particles.size());
    for (size_t i = 0; i < particles.size(); ++i) {
        Half& of = half[particles[i].seed.y > middle ? 1 : 0];
        of.count += 1;
        of.x += now[i].position.x - instance.position.x - particles[i].seed.x;
        of.y += now[i].position.y - instance.position.y - particles[i].seed.y;
        of.z += now[i].position.z - instance.position.z - particles[i].seed.z;
        of.height += particles[i].seed.y;
    }
    const auto mean = [&](int h, double Half::*value) { return half[h].*value / half[h].count; };
    const double apart = mean(1, &Half::height) - mean(0, &Half::height);
    return {std::hypot(mean(1, &Half::x) - mean(0, &Half::x), mean(1, &Half::z) - mean(0, &Half::z)) / apart,
            -mean(0, &Half::y)};
}

/// On a slab of cells ten times as large as its own, 1 mm above it, and half a second later.
TEST_F(FacingBodies, AGlassStandsUprightWhereverItStands) {
    constexpr double kThick = 0.04, kGap = 0.001;
    const auto slab = filledModel("plate.obj", 1.4, 600), glass = filledModel("tumbler.obj", 0.153, 700);
    SceneSetup setup;
    setup.bodies = {placedBody(slab, {})};
    for (const auto& [x, z] : {std::pair{0.1, 0.12}, {-0.3, 0.05}, {0.2, -0.2}, {-0.11, -0.03}})
        setup.bodies.push_back(placedBody(glass, {x, kThick + kGap, z}));
    setup.params.colliders = {Plane{}};
    setup.params.substeps = 100;
    setup.params.settle_time = 0.3;
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const size_t in_slab = slab->particles.size(), in_glass = glass->particles.size();
    const auto now = exportedFrame(*solver, in_slab + 4 * in_glass).particles;
    for (size_t k = 0; k < 4; ++k) {
        const Stance stance = stanceOf(setup.bodies[k + 1], &now[in_slab + k * in_glass]);
        EXPECT_LT(stance.lean, 0.002) << k;
        EXPECT_NEAR(stance.sunk, kGap, 0.0003) << k;
    }
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_EQ(solver->stats().fragments, 5u);
}

/// Bricks in bond, no two beds of which have the same cells above as below.
SceneSetup dryWall() {
    constexpr double kGap = 0.0005;
    SceneSetup setup;
    const std::shared_ptr<const BreakableBody> brick[] = {filledModel("brick.obj", kHeight, 24),
                                                          filledModel("brick.obj", kHeight, 60)};
    for (uint32_t row = 0; row < 6; ++row)
        for (uint32_t k = 0; k < 3; ++k)
            setup.bodies.push_back(placedBody(
                brick[row % 2], {(kLength + kGap) * (k + (row % 2) * 0.3), row * (kHeight + kGap), 0}));
    setup.params.settle_time = 0.2;
    setup.params.substeps = 150;
    return with(setup, {true, true});
}

TEST_F(FacingBodies, ADryWallStandsAndSleeps) {
    const SceneSetup setup = dryWall();
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 240; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    size_t first = 0;
    const auto now = exportedFrame(*solver, streamSizes(setup).particles).particles;
    for (const BodyInstance& body : setup.bodies) {
        const Stance stance = stanceOf(body, &now[first]);
        EXPECT_LT(stance.lean, 0.01);
        EXPECT_LT(std::abs(stance.sunk), 0.004);
        first += body.body->particles.size();
    }
    EXPECT_EQ(solver->stats().awake_particles, 0u);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
}

/// Two bricks of unlike cells and materials that fall on each other, a little turned, without gravity.
SceneSetup meetingBricks() {
    SceneSetup setup;
    setup.bodies = {placedBody(filledModel("brick.obj", kHeight, 60), {}),
                    placedBody(filledModel("brick.obj", kHeight, 24), {0.03, kHeight + 0.003, 0.02})};
    makeUnlike(setup.bodies[1]);
    setup.bodies[1].velocity = {0.1, -0.4, 0.05};
    setup.bodies[1].angular_velocity = {0.3, 0.5, -0.2};
    setup.params.colliders.clear();
    setup.params.gravity = {};
    setup.params.substeps = 150;
    return setup;
}

TEST_F(FacingBodies, OfUnlikeMaterialsMomentumAndEnergyAreKept) {
    for (const Regimes on : {Regimes{false, false}, {true, true}}) {
        auto solver = makeSolver(with(meetingBricks(), on));
        solver->measure();
        const Double3 linear = solver->stats().linear_momentum, angular = solver->stats().angular_momentum;
        const double start = energySum(solver->stats().energy), scale = solver->stats().energy.kinetic;
        for (int frame = 0; frame < 40; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const Double3 now = solver->stats().linear_momentum, turning = solver->stats().angular_momentum;
        const double unit = 1e-5 * std::abs(linear.y);
        EXPECT_NEAR(now.x, linear.x, unit);
        EXPECT_NEAR(now.y, linear.y, unit);
        EXPECT_NEAR(now.z, linear.z, unit);
        EXPECT_NEAR(turning.x, angular.x, kLength * 10 * unit);
        EXPECT_NEAR(turning.y, angular.y, kLength * 10 * unit);
        EXPECT_NEAR(turning.z, angular.z, kLength * 10 * unit);
        EXPECT_NEAR(energySum(solver->stats().energy), start, 0.01 * scale);
        EXPECT_LT(solver->stats().energy.kinetic, 0.9 * scale) << "they have met";
    }
}

TEST_F(FacingBodies, WhatBeginsPressedIntoEachOtherStaysWhereItIs) {
    SceneSetup setup = meetingBricks();
    setup.bodies[1].position.y = kHeight - 0.003;
    setup.bodies[1].velocity = {};
    setup.bodies[1].angular_velocity = {};
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_LT(solver->stats().energy.kinetic, 1e-9);
}

/// Bonds broken in half a second: a ball drops on a brick that lies on another one. Means of three packings.
double brokenByABall(bool upper_breaks, bool hand_over) {
    double broken = 0;
    for (uint64_t packing = 1; packing <= 3; ++packing) {
        const auto brick = filledModel("brick.obj", kHeight, 300, packing);
        SceneSetup setup;
        setup.bodies = {placedBody(brick, {}), placedBody(brick, {0.02, kHeight + 0.0005, 0})};
        if (!upper_breaks) setup.bodies[1].material.critical_velocity = 1e6;
        setup.params.colliders = {Plane{}};
        setup.params.substeps = 200;
        setup.params.settle_time = 0.2;
        Projectile ball;
        ball.radius = 0.05;
        ball.position = {0.01, 0.3, 0.01};
        ball.velocity = {0, -3, 0};
        setup.projectiles = {ball};
        auto solver = makeSolver(with(setup, {hand_over, hand_over}));
        for (int frame = 0; frame < 30; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        broken += solver->stats().bonds_broken / 3.0;
    }
    return broken;
}

/// A push goes through what is hit: what it lies on never sees anything come fast.
TEST_F(FacingBodies, WhatLiesUnderSomethingThatIsHitBreaksAsWithItsBondsAwake) {
    for (const bool upper_breaks : {true, false}) {
        const double awake = brokenByABall(upper_breaks, false);
        EXPECT_GT(awake, 500);
        EXPECT_NEAR(brokenByABall(upper_breaks, true), awake, 0.25 * awake) << upper_breaks;
    }
}

struct Landing {
    double broken = 0, gained = 0;  ///< bonds, means of three packings; of the energy that was brought
};
/// Two bricks, one on the other, land at 5 m/s.
Landing landingOfTwo(bool hand_over) {
    Landing landing;
    for (uint64_t packing = 1; packing <= 3; ++packing) {
        const auto brick = filledModel("brick.obj", kHeight, 300, packing);
        SceneSetup setup;
        setup.bodies = {placedBody(brick, {0, 0.45, 0}), placedBody(brick, {0.02, kHeight + 0.4505, 0})};
        for (BodyInstance& body : setup.bodies) body.velocity = {0, -4, 0};
        setup.params.colliders = {Plane{}};
        setup.params.substeps = 200;
        auto solver = makeSolver(with(setup, {hand_over, hand_over}));
        solver->measure();
        const double brought = solver->stats().energy.kinetic, start = energySum(solver->stats().energy);
        for (int frame = 0; frame < 8; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const double gained = (energySum(solver->stats().energy) - start) / brought;
        if (std::abs(gained) > std::abs(landing.gained)) landing.gained = gained;
        landing.broken += solver->stats().bonds_broken / 3.0;
    }
    return landing;
}

/// What falls along with what it lies on is hit as soon as that lands.
TEST_F(FacingBodies, WhatLiesOnSomethingThatLandsBreaksAsWithItsBondsAwake) {
    const Landing awake = landingOfTwo(false), handed_over = landingOfTwo(true);
    EXPECT_GT(awake.broken, 500);
    EXPECT_NEAR(handed_over.broken, awake.broken, 0.1 * awake.broken);
    EXPECT_NEAR(handed_over.gained, 0, 0.002);
}

/// Two cubes of different bodies: the record says how far apart they touch, and the law is that of the two.
class FacingPair : public Pair {
  protected:
    FacingPair() {
        setState(PairState::kFacing);
        for (uint32_t slot = 0; slot < 2; ++slot)
            data_.bonds.rest.span()[slot] = {(slot == 0 ? 1 : -1) * kApart, 0, 0, 0};
    }
    static constexpr double kApart = 1.3 * kSize;
};

TEST_F(FacingPair, TouchesWhereItsRecordSays) {
    const double overlap = 0.01 * kSize;
    EXPECT_EQ(forceAt(kApart + overlap), 0);
    EXPECT_LT(forceAt(kApart - overlap), 1e-6) << "nobody has seen it come";
    const double force = forceAt(kApart - 2 * overlap);
    setState(PairState::kContact);
    EXPECT_EQ(forceAt(kSize + overlap), 0);
    EXPECT_LT(forceAt(kSize - overlap), 1e-6);
    EXPECT_NEAR(forceAt(kSize - 2 * overlap) / force, 1, 1e-9) << "as spheres press on each other";
}

TEST_F(FacingPair, FarApartItBecomesSpheres) {
    setDistance(1.49 * kApart);
    step();
    EXPECT_EQ(state(0), PairState::kFacing);
    setDistance(1.51 * kApart);
    step();
    for (uint32_t end = 0; end < 2; ++end) EXPECT_EQ(state(end), PairState::kContact);
    EXPECT_EQ(forceAt(0.95 * kApart), 0);
}

/// The second cube has an owner of a hundredth of the stiffness; spheres press on each other by the record of
/// a bond of mortar that has retired.
TEST_F(FacingPair, BothEndsOfARecordAgreeOnTheLawOfTwoOwners) {
    Projectile soft;
    soft.stiffness_factor = 0.01;
    data_.uploadLaws(backend_, buildLawTables(setup_, tables_, {soft}));
    data_.particles.owner.span()[1] = 1;
    for (const PairState state : {PairState::kFacing, PairState::kContact}) {
        setState(state);
        const double touch = state == PairState::kFacing ? kApart : kSize;
        keepTouch(kNeverSoftened);
        EXPECT_GT(forceAt(0.99 * touch), 0);
        EXPECT_EQ(now().velocity[0].x, -now().velocity[1].x);
    }
}

}  // namespace
}  // namespace demolish::tests
