// SPDX-License-Identifier: Apache-2.0
// Plain contact: Hertz impact, restitution, wall factor, adhesion; physics D 1, 2, 3, 6, and dimensions of
// each law.
#include <gtest/gtest.h>

#include "sim_cuda/physics/restitution.h"
#include "tests/physics/laws/laws.h"

namespace demolish {
namespace {

using V = Vec3<double>;
constexpr double kE = 200e9, kNu = 0.25, kRadius = 1e-6, kDensity = 3900;

struct Impact {
    double deepest = 0, duration = 0, restitution = 0;
};

/// Head-on impact in relative coordinates; `law(delta, approach)` is the repulsive force.
template <class Law>
struct HeadOn {
    double reduced_mass, speed, dt;
    Law law;

    DEM_FN Impact operator()() const {
        double delta = 0, approach = speed, time = 0;
        Impact result;
        do {
            const double middle =
                delta + 0.5 * dt * approach;  // velocity Verlet in its drift-kick-drift form
            approach -= dt * law(middle, approach) / reduced_mass;
            delta = middle + 0.5 * dt * approach;
            time += dt;
            result.deepest = maxOf(result.deepest, delta);
        } while (delta > 0);
        result.duration = time;
        result.restitution = -approach / speed;
        return result;
    }
};
template <class Law>
Impact impact(double reduced_mass, double speed, double dt, const Law& law) {
    return laws::evaluate(HeadOn<Law>{reduced_mass, speed, dt, law});
}

/// Hertz's, undamped with alpha 0; N.
struct Hertz {
    double modulus, radius, alpha = 0, reduced_mass = 0;
    DEM_FN double operator()(double delta, double approach) const {
        const double a = contactRadius(radius, delta);
        return repulsion(hertzForce(modulus, a, delta), hertzDamping(alpha, modulus, reduced_mass, a),
                         approach);
    }
};
struct Linear {
    double stiffness, c, reduced_mass;
    DEM_FN double operator()(double delta, double approach) const {
        return repulsion(stiffness * maxOf(delta, 0.0), linearDamping(c, stiffness, reduced_mass), approach);
    }
};

TEST(HertzContact, HeadOnImpactMatchesTheClosedForm) {  // D 1
    const double mass = kDensity * 4 / 3 * kPi * std::pow(kRadius, 3), m_e = laws::reduced(mass, mass);
    const auto moduli = laws::contactModuli(kE, kNu, kE, kNu);
    const double R = laws::reduced(kRadius, kRadius);
    for (const double speed : {1.0, 40.0}) {
        const double expected = std::pow(15 * m_e * speed * speed / (16 * moduli.normal * std::sqrt(R)), 0.4);
        const double duration = 2.943 * expected / speed;
        const auto measured = impact(m_e, speed, duration / 20000, Hertz{moduli.normal, R});
        EXPECT_NEAR(measured.deepest / expected, 1, 1e-3);
        EXPECT_NEAR(measured.duration / duration, 1, 2e-3);
        EXPECT_NEAR(measured.restitution, 1, 1e-3);
    }
}

TEST(Restitution, TableGivesEachCoefficientAtTwoSpeeds) {  // D 2
    const double mass = 1.3, m_e = mass / 2, R = 0.02, E = 5e7, k = 1e6;
    for (int tenth = 1; tenth <= 9; ++tenth) {
        const double e = 0.1 * tenth;
        const auto constants = restitutionConstants(e);
        for (const double speed : {0.5, 8.0}) {
            const double time_hertz =
                2.943 / speed * std::pow(15 * m_e * speed * speed / (16 * E * std::sqrt(R)), 0.4);
            const auto hertz = impact(m_e, speed, time_hertz / 20000, Hertz{E, R, constants.hertz, m_e});
            EXPECT_NEAR(hertz.restitution / e, 1, 0.01) << "Hertz, e " << e << ", v " << speed;
            const auto linear =
                impact(m_e, speed, kPi * std::sqrt(m_e / k) / 20000, Linear{k, constants.linear, m_e});
            EXPECT_NEAR(linear.restitution / e, 1, 0.01) << "linear, e " << e << ", v " << speed;
        }
    }
}

TEST(Restitution, InterpolatesBetweenTheRowsAndEndsAtZero) {
    const double m_e = 0.65, k = 1e6;
    for (const double e : {0.05, 0.15, 0.25, 0.45, 0.85, 0.95}) {
        const auto constants = restitutionConstants(e);
        const auto linear =
            impact(m_e, 2, kPi * std::sqrt(m_e / k) / 20000, Linear{k, constants.linear, m_e});
        EXPECT_NEAR(linear.restitution, e, 0.01) << e;
    }
    EXPECT_EQ(restitutionConstants(1).hertz, 0);
    EXPECT_EQ(restitutionConstants(0).linear, restitutionConstants(0.05).linear);
}

TEST(WallContact, RigidWallGivesTwiceTheForceOfThePaperWithTheSameRadius) {  // D 3
    const auto pair = laws::contactModuli(kE, kNu, kE, kNu), wall = laws::rigidWallModuli(kE, kNu);
    const double delta = 1e-9, a = laws::contactRadius(kRadius, delta);
    EXPECT_DOUBLE_EQ(laws::hertzForce(wall.normal, a, delta), 2 * laws::hertzForce(pair.normal, a, delta));
    EXPECT_DOUBLE_EQ(laws::mindlinStiffness(wall.tangential, a),
                     2 * laws::mindlinStiffness(pair.tangential, a));
}

TEST(HertzContact, EqualMaterialsGiveThePapersPrefactors) {
    const auto moduli = laws::contactModuli(kE, kNu, kE, kNu);
    const double R = 0.5e-6, delta = 2e-9, a = laws::contactRadius(R, delta);
    EXPECT_NEAR(
        laws::hertzForce(moduli.normal, a, delta) / (4.0 / 3 * kE / (1 - kNu * kNu) * a * a * a / (2 * R)), 1,
        1e-14);
    EXPECT_NEAR(laws::mindlinStiffness(moduli.tangential, a) / (2 * kE * a / ((2 - kNu) * (1 + kNu))), 1,
                1e-14);
}

TEST(HertzContact, StiffnessIsTheDerivativeOfTheForce) {
    const double E = 3e9, R = 0.01, delta = 1e-4, h = 1e-9;
    const auto force = [&](double d) { return laws::hertzForce(E, laws::contactRadius(R, d), d); };
    EXPECT_NEAR((force(delta + h) - force(delta - h)) / (2 * h) / (2 * E * laws::contactRadius(R, delta)), 1,
                1e-6);
    EXPECT_EQ(force(-1e-4), 0);
}

/// N, the strongest pull of a contact of modulus E (0: adhesion alone) while it opens.
struct StrongestPull {
    DEM_FN double operator()(double E, double w, double R) const {
        double lowest = 0;
        for (int step = 0; step <= 100000; ++step) {
            const double delta = step * 1e-13;
            lowest =
                minOf(lowest, hertzForce(E, contactRadius(R, delta), delta) - adhesionForce(w, R, delta));
        }
        return -lowest;
    }
};

TEST(Adhesion, PullOffForceIsTheDmtValue) {  // D 6
    const double w = 2, R = 0.64e-6;
    EXPECT_NEAR(laws::evaluate(StrongestPull{}, 0.0, w, R) / (2 * kPi * w * R), 1, 1e-6);
    EXPECT_EQ(laws::adhesionForce(w, R, 0.0), 0);
    EXPECT_EQ(laws::adhesionForce(w, R, -1e-9), 0);
    // With a material soft against adhesion the net pull comes within the ramp of the full value.
    EXPECT_NEAR(laws::evaluate(StrongestPull{}, 1e3, w, R) / (2 * kPi * w * R), 1, 1e-6);
}

/// The spring's energy is what compressing it took: the ledger's 1/2 F delta, or Hertz's 2/5 F delta.
TEST(ContactLaws, EnergyIsTheWorkOfTheForce) {
    for (const uint32_t hertz : {0u, 1u}) {
        TouchStep<double> step;
        step.hertz = hertz;
        step.dt = 1e-4;
        step.stiffness_cap = 1e12;
        const PairLaw<double> pair{1e5, 0, 0.4, 0, 0, 2e7, 8e6};
        const PairInertia<double> against{3.0, 700.0};
        const auto law = [&](double overlap) {
            return laws::contactTouchLaw(pair, step, overlap, 0.02, against);
        };
        const double overlap = 1e-3;
        constexpr int kSlices = 400;
        double work = 0;
        for (int k = 0; k < kSlices; ++k)
            work += law((k + 0.5) * overlap / kSlices).elastic * overlap / kSlices;
        const V spring{3e-5, 0, 4e-5};
        EXPECT_NEAR(laws::touchEnergy(law(overlap), step, overlap, V{}) / work, 1, 1e-4);
        EXPECT_NEAR(laws::touchEnergy(law(overlap), step, overlap, spring) -
                        laws::touchEnergy(law(overlap), step, overlap, V{}),
                    0.5 * law(overlap).shear * 25e-10, 1e-12);
    }
}

TEST(ContactLaws, DampedContactNeverPulls) {
    EXPECT_EQ(laws::repulsion(1.0, 10.0, -5.0), 0.0);
    EXPECT_DOUBLE_EQ(laws::repulsion(1.0, 10.0, 0.3), 4.0);
}

TEST(ContactLaws, ChangeOfUnitsChangesEachLawByItsDimension) {
    const double metre = 3, second = 5, kilogram = 7;  // new units are 1/3 m, 1/5 s, 1/7 kg
    const double force = kilogram * metre / (second * second), pressure = force / (metre * metre);
    const double E = 2e6, R = 0.3, delta = 0.01, m = 1.7, a = laws::contactRadius(R, delta);
    const double a2 = laws::contactRadius(R * metre, delta * metre);
    EXPECT_NEAR(a2 / a, metre, 1e-12);
    EXPECT_NEAR(laws::hertzForce(E * pressure, a2, delta * metre) / laws::hertzForce(E, a, delta), force,
                1e-12);
    EXPECT_NEAR(laws::mindlinStiffness(E * pressure, a2) / laws::mindlinStiffness(E, a), force / metre,
                1e-12);
    EXPECT_NEAR(laws::hertzDamping(0.5, E * pressure, m * kilogram, a2) / laws::hertzDamping(0.5, E, m, a),
                kilogram / second, 1e-12);
    EXPECT_NEAR(
        laws::linearDamping(0.5, 1e3 * force / metre, m * kilogram) / laws::linearDamping(0.5, 1e3, m),
        kilogram / second, 1e-12);
    EXPECT_NEAR(
        laws::adhesionForce(2 * force / metre, R * metre, delta * metre) / laws::adhesionForce(2.0, R, delta),
        force, 1e-12);
}

}  // namespace
}  // namespace demolish
