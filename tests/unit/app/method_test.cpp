// SPDX-License-Identifier: Apache-2.0
// What a method makes of a shot, and how the pieces that methods make are compared.
#include "app/session/method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <thread>

#include "app/commands/shot_options.h"
#include "app/compare/method_row.h"
#include "app/session/scene_file.h"
#include "app/session/shot_setup.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

Shot smallBlock() {
    Shot shot = loadScene("block");
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = 60;
    return shot;
}

SceneSetup setupOf(Method method) {
    Shot shot = smallBlock();
    shot.method = method;
    return prepareShot(shot, {.draw_geometry = false}, {}).setup;
}

ShotOptions options(const std::string& method) {
    ShotOptions options;
    options.scene = "block";
    options.method = method;
    return options;
}

TEST(Method, StandsForValuesOfTheSolver) {
    const SolverParams ours = setupOf(Method::kOurs).params;
    EXPECT_TRUE(ours.hand_over && ours.sleeping && ours.smooth_cracks);
    EXPECT_FALSE(ours.preset_pieces);
    const SolverParams heavy = setupOf(Method::kHeavy).params;
    EXPECT_FALSE(heavy.hand_over || heavy.sleeping || heavy.smooth_cracks);
    EXPECT_EQ(heavy.substeps, 4 * ours.substeps);
    const SolverParams cut = setupOf(Method::kPattern).params;
    EXPECT_EQ(cut.preset_pieces, (PresetPieces{Pattern::kUniform, false}));
    EXPECT_EQ(cut.settle_time, 0) << "settling steps bonds";
    EXPECT_EQ(setupOf(Method::kPatternAtImpact).params.preset_pieces, (PresetPieces{Pattern::kRadial, true}));
    Shot cores = smallBlock();
    cores.device = DeviceChoice::kAuto;
    cores.method = Method::kCores;
    EXPECT_FALSE(choosesCuda(cores));
}

TEST(Method, IsNamedOnTheCommandLine) {
    for (const std::string& name : methodNames())
        EXPECT_STREQ(methodName(makeShot(options(name)).method), name.c_str());
    ShotOptions bricks = options("pattern");
    bricks.pattern = "bricks";
    EXPECT_EQ(makeShot(bricks).pattern, Pattern::kBricks);
    bricks.method = "ours";
    EXPECT_EQ(makeShot(bricks).pattern, Pattern::kBricks) << "of the tough cells";
    bricks.pattern_axis = {1, 0, 0};
    EXPECT_EQ(makeShot(bricks).pattern_axis, (Double3{1, 0, 0}));
    bricks.pattern_axis = {0, 0, 0};
    EXPECT_THROW(makeShot(bricks), UsageError) << "points nowhere";
    bricks.pattern_axis = {1, 0, 0};
    bricks.method = "pattern";
    EXPECT_THROW(makeShot(bricks), UsageError) << "preset pieces stand upright";
    ShotOptions bonds = options("pattern");
    bonds.no_hand_over = true;
    EXPECT_THROW(makeShot(bonds), UsageError);
    ShotOptions gpu = options("cores");
    gpu.device = "cuda";
    EXPECT_THROW(makeShot(gpu), UsageError);
}

TEST(Method, CoresGivesTheBitsOfOurs) {
    const auto hashAfterTheHit = [](Method method) {
        Shot shot = smallBlock();
        shot.method = method;
        shot.impact.times_threshold = 10;
        Session session(buildShot(shot, {}, {}), {.draw = false});
        while (session.solver().stats().time < 1)
            if (session.advance() != StepStatus::kOk) break;
        EXPECT_GT(session.solver().stats().bonds_broken, 0u);
        return session.solver().stateHash();
    };
    EXPECT_EQ(hashAfterTheHit(Method::kCores), hashAfterTheHit(Method::kOurs));
    EXPECT_NE(hashAfterTheHit(Method::kHeavy), hashAfterTheHit(Method::kOurs));
}

TEST(Method, NeedsANewSolverAndTheSameCells) {
    const Shot before = smallBlock();
    Shot after = before;
    after.method = Method::kPattern;
    EXPECT_EQ(changeBetween(before, after), Change::kSolver);
    Shot bricks = after;
    bricks.pattern = Pattern::kBricks;
    EXPECT_EQ(changeBetween(after, bricks), Change::kSolver);
}

TEST(Method, APatternOfToughCellsNeedsNewCells) {
    const Shot before = smallBlock();
    Shot slabs = before;
    slabs.pattern = Pattern::kSlabs;
    EXPECT_EQ(changeBetween(before, slabs), Change::kBody);
    Shot more = slabs;
    more.material.tough_cells += 5;
    EXPECT_EQ(changeBetween(slabs, more), Change::kBody);
    Shot aimed = slabs;
    aimed.impact.height_fraction = 0.3;
    EXPECT_EQ(changeBetween(slabs, aimed), Change::kLive) << "slabs lie as they lie";
    slabs.pattern = aimed.pattern = Pattern::kRadial;
    EXPECT_EQ(changeBetween(slabs, aimed), Change::kBody);
}

TEST(Method, OursBreaksAlongThePatternOfItsToughCells) {
    Shot shot = smallBlock();
    shot.fineness.particles = 400;
    shot.pattern = Pattern::kSlabs;
    shot.pattern_axis = Double3{1, 0, 0};
    shot.material.tough_cells = 4;
    const BuiltShot built = prepareShot(shot, {.draw_geometry = false}, {});
    const BreakableBody& body = *built.body;
    EXPECT_FALSE(built.setup.params.preset_pieces);
    ASSERT_EQ(body.tough_cell.size(), body.particles.size());
    std::map<uint32_t, std::pair<double, double>> slabs;  // least and most x, m
    for (size_t i = 0; i < body.particles.size(); ++i) {
        const double x = body.particles[i].seed.x;
        auto& [least, most] = slabs.try_emplace(body.tough_cell[i], x, x).first->second;
        least = std::min(least, x);
        most = std::max(most, x);
    }
    EXPECT_NEAR(double(slabs.size()), 4, 1);
    std::vector<std::pair<double, double>> along;
    for (const auto& [cell, extent] : slabs) along.push_back(extent);
    std::sort(along.begin(), along.end());
    for (size_t k = 1; k < along.size(); ++k)
        EXPECT_LT(along[k - 1].second - along[k].first, 1.2 * body.spacing);
}

TEST(Method, SwitchesWhileASessionLives) {
    Session session(buildShot(smallBlock(), {}, {}), {.draw = false});
    const auto cells = session.built().body;
    Shot shot = smallBlock();
    shot.method = Method::kPattern;
    session.apply(command::ChangeShot{shot}, 0);
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!session.built().setup.params.preset_pieces && std::chrono::steady_clock::now() < patience) {
        session.update(1, false);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_TRUE(session.built().setup.params.preset_pieces);
    EXPECT_EQ(session.built().body, cells);
}

TEST(Method, TurnsTheImpactByAQuarter) {
    const BuiltShot built = prepareShot(smallBlock(), {.draw_geometry = false}, {});
    Shot shot = smallBlock();
    shot.impact.kind = ImpactKind::kBall;
    shot.impact.direction = {1, -0.5, 0};
    const Double3 way = turnedImpact(shot, *built.body).impact.direction;
    EXPECT_NEAR(way.x, 0, 1e-12);
    EXPECT_NEAR(way.y / way.z, 0.5, 1e-12);
    shot.impact.kind = ImpactKind::kDrop;
    EXPECT_NE(turnedImpact(shot, *built.body).impact.tilt, shot.impact.tilt);
}

TEST(FragmentMap, DistanceIsThatOfHubertAndArabie) {
    const std::vector<uint32_t> a{0, 0, 0, 1, 1, 1}, renamed{5, 5, 5, 2, 2, 2}, b{0, 0, 1, 1, 2, 2};
    EXPECT_EQ(mapDistance(a, a), 0);
    EXPECT_EQ(mapDistance(a, renamed), 0);
    // Pairs together: 2 in both; 6 in a, 3 in b, of 15: (2 - 1.2) / (4.5 - 1.2).
    EXPECT_NEAR(mapDistance(a, b), 1 - 0.8 / 3.3, 1e-12);
    EXPECT_EQ(mapDistance(a, b), mapDistance(b, a));
    std::vector<uint32_t> whole(100, 0), single(100);
    std::iota(single.begin(), single.end(), 0u);
    EXPECT_NEAR(mapDistance(whole, single), 1, 1e-12);
    EXPECT_EQ(mapDistance(whole, whole), 0);
}

TEST(FragmentMap, CountsPieces) {
    const std::vector<uint32_t> map{9, 9, 9, 9, 2, 2, 2, 0, 1, 4};
    const PieceSizes sizes = pieceSizes(map);
    EXPECT_EQ(sizes.pieces, 5u);
    EXPECT_EQ(sizes.single, 3u);
    EXPECT_EQ(sizes.largest, 0.4);
    EXPECT_EQ(sizes.half, 2u);
    EXPECT_EQ(pieceSizes({}).pieces, 0u);
}

TEST(MethodRow, TimesAreThoseOfTheFirstAndTheLastPhase) {
    std::vector<FrameSample> samples(4);
    for (size_t i = 0; i < 4; ++i) {
        samples[i].frame_ms = 10 * double(i + 1);
        samples[i].sim_ms = double(i + 1);
        samples[i].stats.time = 0.1 * double(i + 1);
        samples[i].stats.bonds_broken = i < 1 ? 0 : i < 2 ? 5 : 9;
    }
    MethodRow row;
    const std::vector<Phase> phases{{"whole", 0, 0.2, 0}, {"all broken", 0.3, 0.5, 0}};
    addTimes(samples, phases, row);
    EXPECT_NEAR(row.fps_whole, 1000 / 15.0, 1e-9);
    EXPECT_NEAR(row.fps_broken, 1000 / 40.0, 1e-9);
    addTimes(samples, {}, row);
    EXPECT_NEAR(row.fps_whole, 1000 / 10.0, 1e-9);
    EXPECT_NEAR(row.fps_broken, 1000 / 35.0, 1e-9);
    EXPECT_NEAR(row.sim_ms, 3.5, 1e-9);
}

}  // namespace
}  // namespace demolish
