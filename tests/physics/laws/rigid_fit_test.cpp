// SPDX-License-Identifier: Apache-2.0
// Rigid motion of fragments: momenta kept, kinetic energy never gained: physics D 23.
#include "sim_cuda/physics/rigid_fit.h"
#include "tests/physics/laws/laws.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace demolish {
namespace {
using V = Vec3<double>;

struct Body {
    double mass, inertia;
    V x, v, w;
};
std::vector<Body> randomFragment(size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto draw = [&] { return V{uniform(random), uniform(random), uniform(random)}; };
    std::vector<Body> bodies;
    for (size_t k = 0; k < count; ++k)
        bodies.push_back({0.1 + std::abs(uniform(random)), 0.01, draw() + V{5, 0, 2},
                          3.0 * draw() + V{0, 10, 0}, 8.0 * draw()});
    return bodies;
}
RigidMotion fit(const std::vector<Body>& bodies) {
    MassSums sums;
    for (const auto& b : bodies) sums = sums + laws::massOf(b.mass, b.x, b.v);
    SpinSums spins;
    for (const auto& b : bodies)
        spins = spins + laws::spinOf(b.mass, b.inertia, b.x - laws::massCentre(sums),
                                     b.v - laws::meanVelocity(sums), b.w);
    return laws::rigidMotion(sums, spins);
}
struct Momenta {
    V linear, angular;
    double kinetic = 0;
};
Momenta momentaOf(const std::vector<Body>& bodies) {
    Momenta m;
    for (const auto& b : bodies) {
        m.linear = m.linear + b.mass * b.v;
        m.angular = m.angular + b.mass * cross(b.x, b.v) + b.inertia * b.w;
        m.kinetic += 0.5 * b.mass * length2(b.v) + 0.5 * b.inertia * length2(b.w);
    }
    return m;
}
std::vector<Body> moved(std::vector<Body> bodies, const RigidMotion& motion) {
    for (auto& b : bodies) {
        b.v = laws::velocityAt(motion.velocity, motion.spin, b.x - motion.centre);
        b.w = motion.spin;
    }
    return bodies;
}

TEST(RigidFit, KeepsBothMomentaAndNeverGainsEnergy) {  // D 23
    for (const size_t count : {1u, 2u, 3u, 17u, 500u}) {
        const auto bodies = randomFragment(count, unsigned(count));
        const auto before = momentaOf(bodies), after = momentaOf(moved(bodies, fit(bodies)));
        EXPECT_LT(length(after.linear - before.linear), 1e-12 * length(before.linear)) << count;
        EXPECT_LT(length(after.angular - before.angular), 1e-12 * length(before.angular)) << count;
        EXPECT_LE(after.kinetic, before.kinetic * (1 + 1e-14)) << count;
    }
}

TEST(RigidFit, OneParticleKeepsItsOwnMotion) {
    const auto bodies = randomFragment(1, 3);
    const auto motion = fit(bodies);
    EXPECT_NEAR(length(motion.velocity - bodies[0].v), 0, 1e-14);
    EXPECT_NEAR(length(motion.spin - bodies[0].w), 0, 1e-13);
}

TEST(RigidFit, FindsAKnownRigidMotionAgain) {
    auto bodies = randomFragment(40, 5);
    const RigidMotion truth{{1, 2, 3}, {-2, 0.5, 7}, {4, -3, 9}};
    const auto found = fit(moved(bodies, truth));
    EXPECT_LT(length(found.spin - truth.spin), 1e-12);
    const auto at = [](const RigidMotion& motion) {
        return laws::velocityAt(motion.velocity, motion.spin, V{0.3, 0.2, 0.1} - motion.centre);
    };
    EXPECT_LT(length(at(found) - at(truth)), 1e-12);
}

TEST(RigidFit, UnequalMassesOnALine) {  // the example of A.7 in which unweighted least squares fails
    const std::vector<Body> bodies{{1, 1e-3, {0, 0, 0}, {1, 0, 0}, {}}, {3, 1e-3, {1, 0, 0}, {}, {}}};
    EXPECT_NEAR(4 * fit(bodies).velocity.x, 1, 1e-15);
}

TEST(SolveSymmetric, SolvesAndRefusesSingularMatrices) {
    const Sym3 a{4, 5, 6, 1, -0.5, 0.3};
    const V x{0.2, -3, 1.5}, back = laws::solveSymmetric(a, multiply(a, x));
    EXPECT_LT(length(back - x), 1e-14);
    EXPECT_EQ(length(laws::solveSymmetric(Sym3{1, 0, 1, 0, 0, 0}, V{1, 1, 1})), 0);
}

}  // namespace
}  // namespace demolish
