// SPDX-License-Identifier: Apache-2.0
// The ledger closes in every scene with every material (physics.md D 20), with hand-over and sleep as the
// scene has them.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/commands/shot_options.h"
#include "app/session/data_folder.h"
#include "app/session/scene_file.h"
#include "tests/physics/scenes/outcome.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

constexpr uint32_t kParticles = 200;  // of the body that stays
constexpr double kAfterwards = 0.4;   // s that pieces fly, fall and roll after the hit

/// One body of the scene with the balls that are meant for it, its fastest if the scene has many.
Shot oneBody(const std::string& scene) {
    const Shot whole = loadScene(scene);
    if (whole.bodies.empty()) return smallScene(scene, kParticles);
    uint32_t hit = 0;
    for (const TimedBall& ball : whole.balls)
        if (ball.speed_share == 1) hit = ball.body;
    return smallScene(scene, kParticles, {hit});
}

/// The scene in another material, hit as hard for its strength as the scene's own is.
Shot inMaterial(const std::string& scene, const std::string& material) {
    Shot shot = oneBody(scene);
    const double critical = shot.material.critical_velocity;
    if (!material.empty()) applyMaterial(shot, material);
    if (shot.impact.kind == ImpactKind::kNone)
        shot.impact.kind = ImpactKind::kBall;  // its paths are not here
    shot.impact.velocity *= shot.material.critical_velocity / critical;
    bringForward(shot, {0.1, 0.1});
    return shot;
}

/// What every shot is held to. Most close to a few thousandths; long cells that land on their corners to
/// 1.012.
constexpr double kLeast = 0.98, kMost = 1.02;

void expectClosed(const Shot& shot, const std::string& name) {
    const SceneOutcome outcome = outcomeOf(shot, 0.1 + kAfterwards);
    std::printf("%s, %s: closure %.4f, damping %.3f, friction %.3f, fracture %.3f, %g bonds broken\n",
                shot.scene.c_str(), name.c_str(), outcome.closure, outcome.damping, outcome.friction,
                outcome.fracture, outcome.broken);
    EXPECT_GE(outcome.closure, kLeast) << name;
    EXPECT_LE(outcome.closure, kMost) << name;
    EXPECT_GT(outcome.broken, 10) << name << " is to break";
    for (const double taken : {outcome.damping, outcome.friction, outcome.fracture}) {
        EXPECT_GE(taken, 0) << name;
        EXPECT_LE(taken, 1) << name;
    }
}

class Ledger : public testing::TestWithParam<std::string> {};

TEST_P(Ledger, ClosesInTheScenesMaterialAndInEveryPreset) {
    expectClosed(inMaterial(GetParam(), ""), "own");
    for (const std::string& material : assetNames("materials"))
        expectClosed(inMaterial(GetParam(), material), material);
}

TEST_P(Ledger, ClosesWithoutHandOver) {
    Shot shot = inMaterial(GetParam(), "");
    shot.hand_over = false;
    expectClosed(shot, "own, bonds alone");
}

/// 2 m wide, 1 m high, 3 cm thick.
void writeWall(const std::filesystem::path& file) {
    std::ofstream out(file);
    for (int k = 0; k < 8; ++k)
        out << "v " << ((k & 1) != 0 ? 1 : -1) << ' ' << ((k & 2) != 0 ? 1 : 0) << ' '
            << ((k & 4) != 0 ? 0.015 : -0.015) << '\n';
    for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
        out << "f " << face << '\n';
}

/// Corners that are far from the middle of their cell turn it easily: dampers that do not know this throw it
/// up with a hundred times its energy.
TEST(LedgerOfLongCells, ClosesWhereTheyLandOnTheirCorners) {
    const auto file = std::filesystem::path(testing::TempDir()) / "wall.obj";
    writeWall(file);
    for (const double speed : {5.0, 14.21, 30.0}) {
        Shot shot = smallScene("block", 2);
        shot.model = file;
        shot.impact.kind = ImpactKind::kDrop;
        shot.impact.times_threshold.reset();
        shot.impact.velocity = speed;
        shot.hand_over = false;
        const SceneOutcome outcome = outcomeOf(shot, 1);
        std::printf("%g m/s: closure %.4f\n", speed, outcome.closure);
        EXPECT_NEAR(outcome.closure, 1, 0.02) << speed;
    }
}

/// Between its floor, its bond and a ball a cell is held from three sides at once.
TEST(LedgerOfLongCells, ClosesWhereABallPressesThemOnTheirFloor) {
    const auto file = std::filesystem::path(testing::TempDir()) / "wall.obj";
    writeWall(file);
    ShotOptions options;
    options.model = file.string();
    options.device = "cpu";
    options.material = "stone";
    options.impact_velocity = 0.9033;
    options.particles = 2;
    options.seed = 1919;
    for (const double seconds : {0.1, 1.0}) {
        const SceneOutcome outcome = outcomeOf(makeShot(options, "paper"), seconds);
        std::printf("after %g s: closure %.4f\n", seconds, outcome.closure);
        EXPECT_NEAR(outcome.closure, 1, 0.02) << seconds;
    }
}

/// What lies in contact steps is pulled and pushed for the same time, also where a frame ends with a short
/// one.
TEST(LedgerOfShortSteps, ClosesWhereAFrameIsNoMultipleOfTenSubsteps) {
    ShotOptions options;
    options.scene = "column";
    options.device = "cpu";
    options.material = "marble";
    options.height = 0.2343;
    options.particles = 2;
    options.substeps = 43;
    options.impact_velocity = 0;
    options.no_sleep = true;
    const SceneOutcome outcome = outcomeOf(makeShot(options, "paper"), 0.66);
    EXPECT_NEAR(outcome.closure, 1, 0.0005);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Ledger, testing::ValuesIn(assetNames("scenes")),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace demolish::tests
