// SPDX-License-Identifier: Apache-2.0
// Two balls, or a ball and a wall, in the solver itself: Hertz impact, restitution, rigid wall, adhesion
// (physics.md D 1, 2, 3, 6).
#include <cmath>
#include <vector>

#include "sim_cuda/physics/contact_laws.h"
#include "sim_cuda/solver/double_solver.h"
#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class SolverContact : public OnEitherDevice {};
class SolverContactDouble : public OnTheCpu {};

constexpr double kRadius = 0.1;

/// So soft against its step that a contact lasts hundreds of substeps.
SceneSetup softBall(ContactLaw law, double restitution) {
    SceneSetup setup = freeBody(ballBody(kRadius));
    setup.params.contact_law = law;
    setup.params.step_safety = 0.004;
    setup.params.ledger = false;
    setup.bodies[0].material.restitution = restitution;
    setup.bodies[0].material.rolling_friction = 0;
    setup.bodies[0].position = {0, -kRadius, 0};
    return setup;
}

/// Head-on along x at relative speed v, at first just apart.
SceneSetup headOn(ContactLaw law, double restitution, double v) {
    SceneSetup setup = softBall(law, restitution);
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[0].position.x = -1.0001 * kRadius;
    setup.bodies[1].position.x = 1.0001 * kRadius;
    setup.bodies[0].velocity.x = v / 2;
    setup.bodies[1].velocity.x = -v / 2;
    return setup;
}

struct Impact {
    double deepest = 0, duration = 0, restitution = 0;
};

/// `look` substeps at a time until the balls are apart again.
Impact impactOf(Solver& solver, uint32_t look) {
    solver.measure();
    const double before = solver.stats().energy.kinetic;
    Impact impact;
    bool touched = false;
    for (int step = 0; step < 20000; ++step) {
        EXPECT_EQ(solver.advanceSubsteps(look), StepStatus::kOk);
        const std::vector<ParticleInstance> shown = exportedFrame(solver, 2).particles;
        const double overlap = 2 * kRadius - (static_cast<double>(shown[1].position.x) -
                                              static_cast<double>(shown[0].position.x));
        if (overlap > 0) {
            touched = true;
            impact.duration += look * solver.stats().time_step;
            impact.deepest = std::max(impact.deepest, overlap);
        } else if (touched) {
            break;
        }
    }
    solver.measure();
    impact.restitution = std::sqrt(solver.stats().energy.kinetic / before);
    return impact;
}

TEST_F(SolverContact, FinerStepsMakeNoContactHarder) {
    const auto impactAt = [](uint32_t finer) {
        SceneSetup setup = headOn(ContactLaw::kLinear, 0.9, 0.5);
        setup.params.substeps *= finer;
        setup.params.step_safety = 0.5 / finer;
        return impactOf(*makeSolver(setup), 1);
    };
    const Impact usual = impactAt(1), fine = impactAt(8);
    EXPECT_NEAR(fine.deepest / usual.deepest, 1, 0.05);
    EXPECT_NEAR(fine.duration / usual.duration, 1, 0.15);
}

TEST_F(SolverContact, HertzHeadOnImpactMatchesTheClosedForm) {  // D 1
    const double v = 0.5;
    auto solver = makeSolver(headOn(ContactLaw::kHertz, 1, v));
    const Material material = brittleMaterial();
    const double modulus = solver->softening().bond_modulus, mass = solver->stats().mass / 2;
    const double E = contactModuli(modulus, material.poisson_ratio, modulus, material.poisson_ratio).normal;
    const double R = kRadius / 2, m_e = mass / 2;
    const double deepest = std::pow(15 * m_e * v * v / (16 * E * std::sqrt(R)), 0.4);
    const Impact impact = impactOf(*solver, 1);
    EXPECT_NEAR(impact.deepest / deepest, 1, 1e-3);
    EXPECT_NEAR(impact.duration / (2.943 * deepest / v), 1, 2e-3);
    EXPECT_NEAR(impact.restitution, 1, 1e-3);
}

TEST_F(SolverContact, RestitutionIsTheOneAskedForAtTwoSpeeds) {  // D 2
    for (const ContactLaw law : {ContactLaw::kHertz, ContactLaw::kLinear})
        for (int tenth = 1; tenth <= 9; ++tenth)
            for (const double v : {0.2, 1.6}) {
                const double e = 0.1 * tenth;
                EXPECT_NEAR(impactOf(*makeSolver(headOn(law, e, v)), 40).restitution / e, 1, 0.01)
                    << "law " << static_cast<int>(law) << ", e " << e << ", v " << v;
            }
}

/// N, upwards, on a ball that is pressed `overlap` deep into the floor and let go.
double floorForce(Solver& solver) {
    EXPECT_EQ(solver.advanceSubsteps(1), StepStatus::kOk);
    solver.measure();
    return solver.stats().linear_momentum.y / solver.stats().time_step;
}
SceneSetup pressed(double overlap, double adhesion) {
    SceneSetup setup = softBall(ContactLaw::kHertz, 1);
    setup.params.colliders.push_back(Plane{});
    setup.bodies[0].position.y = -overlap;
    setup.bodies[0].material.adhesion_energy = adhesion;
    return setup;
}
double paperForce(const Solver& solver, double overlap) {  // (1) with R* = R
    const double modulus = solver.softening().bond_modulus, nu = brittleMaterial().poisson_ratio;
    return hertzForce(contactModuli(modulus, nu, modulus, nu).normal, contactRadius(kRadius, overlap),
                      overlap);
}

constexpr double kOverlap = 0.02 * kRadius;

TEST_F(SolverContact, ARigidWallPushesTwiceAsHardAsThePaperPrints) {  // D 3
    auto solver = makeSolver(pressed(kOverlap, 0));
    EXPECT_NEAR(floorForce(*solver) / (2 * paperForce(*solver, kOverlap)), 1, 1e-5);
}

TEST_F(SolverContactDouble, ARigidWallPushesTwiceAsHardAsThePaperPrints) {
    auto solver = makeCpuSolverDouble(pressed(kOverlap, 0));
    EXPECT_NEAR(floorForce(*solver) / (2 * paperForce(*solver, kOverlap)), 1, 1e-12);
}

TEST_F(SolverContactDouble, AdhesionPullsWithTheDmtForce) {  // D 6
    const double w = 0.7;
    auto with = makeCpuSolverDouble(pressed(kOverlap, w)),
         without = makeCpuSolverDouble(pressed(kOverlap, 0));
    EXPECT_NEAR((floorForce(*without) - floorForce(*with)) / (2 * kPi * w * kRadius), 1, 1e-6);
}

TEST_F(SolverContact, AdhesionPullsWithTheDmtForce) {
    const double w = 1e3;  // enough to be seen in single precision
    auto with = makeSolver(pressed(kOverlap, w)), without = makeSolver(pressed(kOverlap, 0));
    EXPECT_NEAR((floorForce(*without) - floorForce(*with)) / (2 * kPi * w * kRadius), 1, 1e-4);
}

}  // namespace
}  // namespace demolish::tests
