// SPDX-License-Identifier: Apache-2.0
// The material presets: real values within the ranges of their sources, and books that close when such a body
// breaks (physics.md D 20).
#include <gmock/gmock.h>

#include <array>
#include <map>

#include "app/session/data_folder.h"
#include "app/session/energy_balance.h"
#include "app/session/scene_file.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Presets : public OnEitherDevice {};

Shot withPreset(const std::string& name) {
    Shot shot;
    applyMaterial(shot, name);
    return shot;
}

struct Real {
    Range density, modulus, poisson, strength;
};

TEST_F(Presets, AreRealMaterials) {
    const std::map<std::string, Real> expected = {
        {"glass", {{2400, 2600}, {69e9, 74e9}, {0.2, 0.23}, {30e6, 100e6}}},
        {"ceramic", {{2200, 2500}, {60e9, 100e9}, {0.17, 0.25}, {25e6, 140e6}}},
        {"plaster", {{1000, 1200}, {3e9, 10e9}, {0.2, 0.25}, {1e6, 4e6}}},
        {"stone", {{2600, 2750}, {30e9, 60e9}, {0.1, 0.3}, {7e6, 25e6}}},
        {"concrete", {{2300, 2450}, {30e9, 37e9}, {0.15, 0.25}, {2.2e6, 4.1e6}}},
        {"ice", {{900, 920}, {8.5e9, 10e9}, {0.3, 0.35}, {0.7e6, 3.1e6}}},
        {"marble", {{2600, 2750}, {40e9, 70e9}, {0.2, 0.3}, {5e6, 15e6}}},
        {"brick", {{1600, 2000}, {5e9, 20e9}, {0.1, 0.25}, {1e6, 4e6}}},
        {"terracotta", {{1700, 2100}, {10e9, 25e9}, {0.15, 0.25}, {3e6, 12e6}}},
        {"cast_iron", {{7000, 7400}, {80e9, 150e9}, {0.24, 0.28}, {100e6, 350e6}}},
        {"tempered_glass", {{2400, 2600}, {69e9, 74e9}, {0.2, 0.23}, {120e6, 200e6}}}};
    for (const auto& [name, real] : expected) {
        const Material m = withPreset(name).material;
        const auto within = [&](double value, const Range& range, const char* what) {
            EXPECT_GE(value, range.least) << name << ' ' << what;
            EXPECT_LE(value, range.most) << name << ' ' << what;
        };
        within(m.density, real.density, "density");
        within(m.youngs_modulus, real.modulus, "modulus");
        within(m.poisson_ratio, real.poisson, "Poisson ratio");
        within(m.tensile_strength, real.strength, "strength");
    }
    EXPECT_GE(assetNames("materials").size(), expected.size());
}

TEST_F(Presets, LookDifferent) {
    std::map<std::array<float, 3>, std::string> colours;
    for (const std::string& name : assetNames("materials")) {
        const auto& c = withPreset(name).look.exterior_colour;
        EXPECT_TRUE(colours.emplace(std::array<float, 3>{c[0], c[1], c[2]}, name).second) << name;
    }
}

SceneSetup broken(const std::string& preset, double speed_over_critical) {
    SceneSetup setup = freeBody(latticeBody(6, 6, 6, 0.05, 0.2));
    BodyInstance& body = setup.bodies[0];
    body.material = withPreset(preset).material;
    body.position = {0, 0.12, 0};
    body.rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
    body.velocity = {0, -speed_over_critical * body.material.critical_velocity, 0};
    Projectile ball;
    ball.radius = 0.05;
    ball.position = {-0.35, 0.2, 0};
    ball.velocity = {3 * body.material.critical_velocity, 0, 0};
    setup.projectiles.push_back(ball);
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {0, -9.81, 0};
    setup.params.substeps = 200;
    return setup;
}

TEST_F(Presets, TheBooksCloseForEveryOne) {
    for (const std::string& name : assetNames("materials"))
        for (const double speed : {1.0, 3.0}) {
            auto solver = makeSolver(broken(name, speed));
            ASSERT_EQ(solver->advanceSubsteps(1), StepStatus::kOk);  // the ball is in the air
            solver->measure();
            EnergyBalance balance{solver->stats().energy, {}};
            for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            solver->measure();
            balance.now = solver->stats().energy;
            EXPECT_GT(solver->stats().bonds_broken, 20u) << name << " at " << speed;
            EXPECT_GE(balance.closure(), 0.995) << name << " at " << speed;
            EXPECT_LE(balance.closure(), 1.05) << name << " at " << speed;
            RecordProperty(name + (speed < 2 ? "_slow" : "_fast"), std::to_string(balance.closure()));
        }
}

}  // namespace
}  // namespace demolish::tests
