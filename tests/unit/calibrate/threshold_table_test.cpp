// SPDX-License-Identifier: Apache-2.0
// Predictions: rows, interpolation, the rule for other bodies, and what follows for a shot.
#include "app/session/threshold_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/session/built_shot.h"
#include "app/session/data_folder.h"
#include "app/session/scene_file.h"
#include "app/session/session.h"
#include "app/session/threshold.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

using test::TemporaryFolder;

const char* const kRows =
    "version = 1\n"
    "[[beta]]\ntough_factor = 1\nat_12 = 0.6\nexponent = 0.4\n"
    "[[beta]]\ntough_factor = 3\nat_12 = 0.4\nexponent = 0.2\n"
    "[[body]]\nname = \"pot\"\ndrop = 0.3\ndrop_scatter = 0.2\nball = 4\n"
    "ball_mass_ratio = 0.1\nball_scatter = 0.1\n"
    "[rule.drop]\nscale = 1\nslimness_exponent = 2\nscatter = 1.5\n"
    "[rule.ball]\nscale = 0.1\nslimness_exponent = -1\nmass_exponent = -2\nscatter = 2\n";

Material material(double tough_factor, double beta = 0.4) {
    Material m;
    m.tough_cells = 40;
    m.tough_factor = tough_factor;
    m.beta = beta;
    return m;
}

class Table : public testing::Test {
  protected:
    TemporaryFolder folder_;
    ThresholdTable table_{folder_.write("table.toml", kRows)};
};

TEST_F(Table, BetaFollowsCellsAndFineness) {
    EXPECT_DOUBLE_EQ(table_.sphereBeta(material(1), 12.4), 0.6);
    EXPECT_DOUBLE_EQ(table_.sphereBeta(material(2), 12.4), 0.5);
    EXPECT_DOUBLE_EQ(table_.sphereBeta(material(9), 12.4), 0.4);
    EXPECT_NEAR(table_.sphereBeta(material(3), 24.8), 0.4 * std::pow(2, 0.2), 1e-12);
    Material no_cells = material(3);
    no_cells.tough_cells = 0;
    EXPECT_DOUBLE_EQ(table_.sphereBeta(no_cells, 12.4), 0.6);
}

TEST_F(Table, ANamedRowCounts) {
    const auto drop = table_.predict("pot", material(3), {12.4, 0.5, 0});
    EXPECT_TRUE(drop.is_known);
    EXPECT_NEAR(drop.share, 0.3, 1e-12);
    EXPECT_EQ(table_.rows(), std::vector<std::string>{"pot"});
    EXPECT_NEAR(table_.predict("pot", material(3, 0.8), {12.4, 0.5, 0}).share, 0.6, 1e-12);
}

TEST_F(Table, AHeavierBallBreaksEarlier) {
    EXPECT_NEAR(table_.predict("pot", material(3), {12.4, 0.5, 0.1}).share, 4, 1e-12);
    EXPECT_NEAR(table_.predict("pot", material(3), {12.4, 0.5, 0.2}).share, 1, 1e-12);
}

TEST_F(Table, OtherBodiesFollowTheRule) {
    const auto drop = table_.predict("", material(3), {12.4, 0.5, 0});
    EXPECT_FALSE(drop.is_known);
    EXPECT_NEAR(drop.share, 0.25, 1e-12);
    EXPECT_EQ(drop.scatter, 1.5);
    EXPECT_NEAR(table_.predict("", material(3), {12.4, 0.5, 0.5}).share, 0.1 / 0.5 / 0.25, 1e-12);
}

TEST_F(Table, RefusesRowsOutOfOrderAndUnknownKeys) {
    const std::string rows = kRows;
    EXPECT_THROW(ThresholdTable(folder_.write("a.toml", rows + "speed = 1\n")), InputFileError);
    EXPECT_THROW(ThresholdTable(folder_.write("b.toml",
                                              "version = 1\n[[beta]]\ntough_factor = 2\nat_12 = 1\n[[beta]]\n"
                                              "tough_factor = 1\nat_12 = 1\n")),
                 InputFileError);
    EXPECT_THROW(ThresholdTable(folder_.path() / "none.toml"), InputFileError);
}

TEST(Threshold, TheShippedTableKnowsTheBodiesOfTheScenes) {
    for (const char* scene : {"bunny", "wolf", "vase", "column", "block"}) {
        Shot shot = loadScene(scene);
        shot.fineness.particles = 150;
        shot.settle_time = 0;
        shot.device = DeviceChoice::kCpu;
        const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
        const auto threshold = thresholdOf(shot, *built.body);
        ASSERT_TRUE(threshold) << scene;
        EXPECT_TRUE(threshold->is_known_body) << scene;
        EXPECT_NEAR(built.setup.bodies[0].threshold_share, lowestThresholdShare(shot, *built.body), 0);
        EXPECT_LE(built.setup.bodies[0].threshold_share,
                  threshold->predicted / shot.material.critical_velocity + 1e-3);
    }
}

/// A model file under a name of its own, run for a while by its ball.
struct NamedRun {
    double share = 0;
    uint64_t hash = 0;
    bool is_known = false;
};
NamedRun runOf(const std::filesystem::path& model, const std::string& strength_row = "") {
    Shot shot;
    applyMaterial(shot, "ceramic");
    shot.model = model;
    shot.strength_row = strength_row;
    shot.fineness.particles = 200;
    shot.device = DeviceChoice::kCpu;
    shot.hand_over = shot.sleeping = true;
    shot.impact.velocity = 60;
    shot.impact.arrival_time = 0.05;
    Session session(buildShot(shot, {.draw_geometry = false}, {}), {.draw = false});
    for (int frame = 0; frame < 40; ++frame) EXPECT_EQ(session.advance(), StepStatus::kOk);
    const BuiltShot& built = session.built();
    return {built.setup.bodies[0].threshold_share, session.solver().stateHash(),
            thresholdOf(built.shot, *built.body)->is_known_body};
}

TEST(Threshold, AModelsFileNameIsNotPartOfItsPhysics) {
    const TemporaryFolder folder;
    const auto mesh = dataFolder() / "assets/models/rabbit_paper.obj";
    const NamedRun rabbit = runOf(mesh);
    for (const char* name : {"rabbit.obj", "hare.obj"}) {
        std::filesystem::copy_file(mesh, folder.path() / name);
        const NamedRun renamed = runOf(folder.path() / name);
        EXPECT_EQ(renamed.share, rabbit.share) << name;
        EXPECT_EQ(renamed.hash, rabbit.hash) << name;
        EXPECT_FALSE(renamed.is_known) << name;
    }
    const NamedRun named = runOf(folder.path() / "hare.obj", "rabbit");
    EXPECT_TRUE(named.is_known);
    EXPECT_NE(named.share, rabbit.share);
}

TEST(Threshold, PiecesOfAVaseWakeByANumberOfTheirOwn) {
    Shot shot = loadScene("vase");
    shot.fineness.particles = 600;
    shot.settle_time = 0;
    shot.device = DeviceChoice::kCpu;
    const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
    shot.impact.kind = ImpactKind::kDrop;
    const double predicted = thresholdOf(shot, *built.body)->predicted / shot.material.critical_velocity;
    EXPECT_NEAR(lowestThresholdShare(shot, *built.body) / predicted, 0.17 / 0.225, 0.01);
}

/// The table's number is that of the plain body, and is not told as if it were more.
TEST(Threshold, ThePaintThatTheTableDoesNotKnowIsSaid) {
    Shot shot = loadScene("block");
    shot.fineness.particles = 60;
    shot.device = DeviceChoice::kCpu;
    BreakableBody body = *buildShot(shot, {.draw_geometry = false}, {}).body;
    const Threshold plain = thresholdOf(shot, body).value();
    body.bond_strength.assign(body.bonds.size(), 0.5);
    Threshold painted = thresholdOf(shot, body).value();
    EXPECT_EQ(painted.predicted, plain.predicted);
    EXPECT_EQ(plain.source().find("painted"), std::string::npos);
    EXPECT_EQ(painted.source(),
              plain.source() + ", as if it were not painted: where it is weaker it breaks from less");
    painted.measured = 3;
    painted.packings = 4;
    EXPECT_EQ(painted.source(), "measured on 4 packings") << "with its paint";
}

TEST(Threshold, BreakAtSetsTheStrength) {
    Shot shot = loadScene("block");
    shot.fineness.particles = 150;
    shot.device = DeviceChoice::kCpu;
    shot.break_at = 6;
    const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
    EXPECT_NEAR(thresholdOf(built.shot, *built.body)->predicted, 6, 1e-9);
    EXPECT_NEAR(built.setup.bodies[0].material.critical_velocity, built.shot.material.critical_velocity, 0);
    shot.impact.kind = ImpactKind::kNone;
    EXPECT_THROW(buildShot(shot, {.draw_geometry = false}, {}), UsageError);
    shot.break_at = -1;
    EXPECT_THROW(validate(shot), UsageError);
}

}  // namespace
}  // namespace demolish
