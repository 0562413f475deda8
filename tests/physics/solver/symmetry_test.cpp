// SPDX-License-Identifier: Apache-2.0
// What must not matter: which body or particle comes first, and the units that everything is measured in.
#include <algorithm>
#include <cmath>

#include "sim_cuda/solver/double_solver.h"
#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Symmetry : public OnTheCpu {};
class SymmetryInSingle : public OnEitherDevice {};

/// Two different bricks that meet at a slant.
SceneSetup twoBricks(bool exchanged) {
    SceneSetup setup = freeBody(latticeBody(4, 4, 3, 0.05, 0.2));
    Material& material = setup.bodies[0].material;
    material.tough_cells = 0;  // drawn by particle number
    setup.bodies[0].position = {-0.13, 0, 0};
    setup.bodies[0].velocity = {4, 1, 0};
    setup.bodies.push_back({latticeBody(3, 5, 4, 0.05, 0.2, 7), material, {}, {}, {}, {}});
    setup.bodies[1].material.friction = 0.2;
    setup.bodies[1].material.restitution = 0.4;
    setup.bodies[1].material.density = 1800;
    setup.bodies[1].position = {0.11, 0.02, 0.01};
    setup.bodies[1].velocity = {-4, 0, 0.5};
    setup.bodies[1].angular_velocity = {0, 3, 1};
    setup.params.colliders.push_back(Plane{{0, 1, 0}, -0.02});
    setup.params.gravity = {0, -9.81, 0};
    if (exchanged) std::swap(setup.bodies[0], setup.bodies[1]);
    return setup;
}

/// The same body with its particles numbered backwards.
std::shared_ptr<const BreakableBody> renumbered(const BreakableBody& body) {
    auto result = std::make_shared<BreakableBody>(body);
    const auto last = static_cast<uint32_t>(body.particles.size()) - 1;
    std::reverse(result->particles.begin(), result->particles.end());
    result->corners = {};
    for (uint32_t i = last + 1; i-- > 0;) {  // boxes: the first and the last of eight are opposite
        const Double3* corners = &body.corners.from_seed[body.corners.start[i]];
        appendBoxCorners(result->corners, corners[0], corners[7]);
    }
    for (BondGeometry& bond : result->bonds) {
        const uint32_t i = bond.i;
        bond.i = last - bond.j;
        bond.j = last - i;
    }
    for (BondGeometry& bond : result->bonds) bond.normal = {-bond.normal.x, -bond.normal.y, -bond.normal.z};
    std::sort(result->bonds.begin(), result->bonds.end(),
              [](const auto& a, const auto& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
    return result;
}

FrameStats after(Solver& solver, uint32_t substeps) {
    EXPECT_EQ(solver.advanceSubsteps(substeps), StepStatus::kOk);
    solver.measure();
    return solver.stats();
}

/// Lengths, times and masses of `b` are these multiples of those of `a`.
struct Units {
    double length = 1, time = 1, mass = 1;
    double velocity() const { return length / time; }
    double energy() const { return mass * velocity() * velocity(); }
};

void expectSame(const FrameStats& a, const FrameStats& b, double tolerance, const Units& units = {}) {
    EXPECT_EQ(a.bonds_broken, b.bonds_broken);
    EXPECT_EQ(a.fragments, b.fragments);
    EXPECT_NEAR(b.time / (units.time * a.time), 1, 1e-12);
    const double energy = units.energy(), scale = a.energy.kinetic;
    EXPECT_NEAR(b.energy.kinetic / energy, a.energy.kinetic, tolerance * scale);
    EXPECT_NEAR(b.energy.elastic / energy, a.energy.elastic, tolerance * scale);
    EXPECT_NEAR(b.energy.damping / energy, a.energy.damping, tolerance * scale);
    EXPECT_NEAR(b.energy.friction / energy, a.energy.friction, tolerance * scale);
    EXPECT_NEAR(b.energy.fracture / energy, a.energy.fracture, tolerance * scale);
    const double momentum = units.mass * units.velocity(), spin = momentum * units.length;
    const Double3 p = a.linear_momentum, q = b.linear_momentum, l = a.angular_momentum,
                  k = b.angular_momentum;
    const double size = std::sqrt(2 * a.mass * scale);
    EXPECT_NEAR(std::hypot(q.x / momentum - p.x, q.y / momentum - p.y, q.z / momentum - p.z), 0,
                tolerance * size);
    EXPECT_NEAR(std::hypot(k.x / spin - l.x, k.y / spin - l.y, k.z / spin - l.z), 0, tolerance * size);
}

TEST_F(Symmetry, TheOrderOfTheBodiesDoesNotMatter) {
    const FrameStats a = after(*makeCpuSolverDouble(twoBricks(false)), 500),
                     b = after(*makeCpuSolverDouble(twoBricks(true)), 500);
    EXPECT_GT(a.bonds_broken, 10u);
    expectSame(a, b, 1e-8);
}

TEST_F(SymmetryInSingle, TheOrderOfTheBodiesDoesNotMatter) {  // until rounding differs by more than it may
    const FrameStats a = after(*makeSolver(twoBricks(false)), 150),
                     b = after(*makeSolver(twoBricks(true)), 150);
    EXPECT_GT(a.energy.damping, 0);
    expectSame(a, b, 1e-4);
}

TEST_F(Symmetry, TheNumbersOfTheParticlesDoNotMatter) {
    SceneSetup setup = twoBricks(false);
    setup.params.soften = false;  // the softening rule finds the highest frequency only to some digits, and
    for (BodyInstance& body : setup.bodies) {  // with another start for every numbering; so does the damper
        body.material.youngs_modulus = 2e8;
        body.material.damping_ratio = 0;
    }
    const FrameStats a = after(*makeCpuSolverDouble(setup), 500);
    for (BodyInstance& body : setup.bodies) body.body = renumbered(*body.body);
    expectSame(a, after(*makeCpuSolverDouble(setup), 500), 1e-8);
}

Double3 times(double factor, const Double3& v) {
    return {factor * v.x, factor * v.y, factor * v.z};
}

std::shared_ptr<const BreakableBody> enlarged(const BreakableBody& body, double length) {
    auto result = std::make_shared<BreakableBody>(body);
    const double area = length * length, volume = area * length;
    for (Particle& p : result->particles) {
        p.seed = times(length, p.seed);
        p.centroid = times(length, p.centroid);
        p.volume *= volume;
        p.depth *= length;
        p.lowest *= length;
    }
    for (BondGeometry& bond : result->bonds) {
        bond.area *= area;
        bond.centroid = times(length, bond.centroid);
        bond.length *= length;
    }
    for (Double3& corner : result->corners.from_seed) corner = times(length, corner);
    result->spacing *= length;
    return result;
}

/// The breaking scene as another world sees it whose metre, second and kilogram are smaller by these factors.
SceneSetup inUnits(const Units& units) {
    SceneSetup setup = breakingScene();
    setup.bodies[0].material.adhesion_energy = 0.005;
    const double velocity = units.velocity(), density = units.mass / std::pow(units.length, 3);
    for (BodyInstance& body : setup.bodies) {
        body.body = enlarged(*body.body, units.length);
        body.position = times(units.length, body.position);
        body.velocity = times(velocity, body.velocity);
        body.angular_velocity = times(1 / units.time, body.angular_velocity);
        body.material.density *= density;
        body.material.critical_velocity *= velocity;
        body.material.adhesion_energy *= units.energy() / (units.length * units.length);
    }
    for (Projectile& ball : setup.projectiles) {
        ball.position = times(units.length, ball.position);
        ball.velocity = times(velocity, ball.velocity);
        ball.radius *= units.length;
        ball.density *= density;
        ball.start_time *= units.time;
    }
    SolverParams& params = setup.params;
    params.gravity = times(velocity / units.time, params.gravity);
    params.substeps = static_cast<uint32_t>(std::lround(params.substeps / units.time));
    params.frame_time *= units.time;
    params.scene_radius *= units.length;
    return setup;
}

TEST_F(Symmetry, UnitsDoNotMatter) {
    const FrameStats a = after(*makeCpuSolverDouble(inUnits({})), 300);
    EXPECT_GT(a.bonds_broken, 500u);
    expectSame(a, after(*makeCpuSolverDouble(inUnits({100, 10, 3e6})), 300), 1e-8, {100, 10, 3e6});
}

TEST_F(SymmetryInSingle, UnitsThatAreTwoToSomePowerChangeNoBitOfTheMantissas) {
    const FrameStats a = after(*makeSolver(inUnits({})), 700);
    expectSame(a, after(*makeSolver(inUnits({4, 2, 16})), 700), 1e-12, {4, 2, 16});
}

TEST_F(Symmetry, UnitsDoNotMatterToHertzContactsAndThePapersLaw) {
    const auto run = [](const Units& units) {
        SceneSetup setup = inUnits(units);
        setup.params.contact_law = ContactLaw::kHertz;
        setup.bodies[0].material.bond_law = BondLaw::kPaper;
        return after(*makeCpuSolverDouble(setup), 300);
    };
    const FrameStats a = run({});
    EXPECT_GT(a.bonds_broken, 100u);
    expectSame(a, run({100, 10, 3e6}), 1e-8, {100, 10, 3e6});
}

}  // namespace
}  // namespace demolish::tests
