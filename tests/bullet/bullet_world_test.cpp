// SPDX-License-Identifier: Apache-2.0
#include "tests/bullet/bullet_run.h"

#include <gtest/gtest.h>

#include <numeric>

#include "app/session/built_shot.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::bullet {
namespace {

/// The first 8 cells of the scene's block one piece, the others each their own.
std::vector<Piece> fewPieces(const SceneSetup& setup) {
    std::vector<uint32_t> fragment(setup.bodies[0].body->particles.size());
    std::iota(fragment.begin(), fragment.end(), 0u);
    std::fill_n(fragment.begin(), 8, 0u);
    return piecesOf(setup, fragment);
}

TEST(BulletWorld, PiecesWeighWhatTheBodyWeighsAndComeToRestOnTheFloor) {
    Shot shot = tests::smallScene("vase", 60, {17});
    const BuiltShot built = prepareShot(shot, {}, {});
    const std::vector<Piece> pieces = fewPieces(built.setup);
    ASSERT_EQ(pieces.size(), 60u - 7);
    double mass = 0, expected = 0;
    for (const Piece& piece : pieces) mass += piece.mass;
    for (const Particle& p : built.body->particles)
        expected += p.volume * built.setup.bodies[0].material.density;
    EXPECT_NEAR(mass, expected, 1e-9 * expected);
    World world(pieces);
    Projectile ball;
    ball.position = {pieces[0].centre.x - 0.5, pieces[0].centre.y, pieces[0].centre.z};
    ball.velocity = {10, 0, 0};
    world.fire(ball);
    for (int frame = 0; frame < 240; ++frame) world.advance(1.0 / 60);
    for (size_t p = 0; p < world.pieces(); ++p) EXPECT_GT(world.centre(p).y, -0.01) << "piece " << p;
}

TEST(BulletWorld, WhatNothingTouchesSleeps) {
    const BuiltShot built = prepareShot(tests::smallScene("vase", 60, {17}), {}, {});
    const std::vector<Piece> pieces = fewPieces(built.setup);
    World world(pieces);
    for (int frame = 0; frame < 30; ++frame) world.advance(1.0 / 60);
    for (size_t p = 0; p < world.pieces(); ++p) EXPECT_NEAR(world.centre(p).y, pieces[p].centre.y, 1e-6);
}

/// What `demolish bench --methods` says of the same shot by Method::kPattern.
TEST(BulletRow, IsOfThePiecesThatPatternCuts) {
    Shot shot = tests::smallScene("vase", 60, {17, 13});
    tests::bringForward(shot, {.first = 0.1, .last = 0.2});
    shot.device = DeviceChoice::kCpu;
    shot.method = Method::kPattern;
    MethodsPlace pattern_place{shot.scene, "nobody", 0, 0, 40}, place = pattern_place;
    const Method methods[] = {Method::kPattern};
    const BenchPlan plan{BenchMode::kSimulateOnly, 40, 0};
    const MethodRow pattern = compareMethods(shot, methods, plan, {}, {}, pattern_place).front();
    const MethodRow row = bulletRow(shot, {}, {}, place);
    EXPECT_EQ(row.name, "bullet");
    EXPECT_GT(row.sizes.pieces, 2u);
    EXPECT_EQ(row.sizes.pieces, pattern.sizes.pieces);
    EXPECT_EQ(row.sizes.half, pattern.sizes.half);
    EXPECT_EQ(row.moved, pattern.moved);
    EXPECT_EQ(row.turned_pieces, pattern.turned_pieces);
    EXPECT_EQ(place.particles, pattern_place.particles);
    EXPECT_FALSE(row.closure) << "Bullet keeps no books";
    ASSERT_TRUE(row.most_energy);
    EXPECT_GT(*row.most_energy, 0.5);
    EXPECT_LT(*row.most_energy, 2);
    const std::string table = methodsTable({&row, 1}, place), json = methodsJson({&row, 1}, place);
    EXPECT_NE(table.find("bullet"), std::string::npos);
    EXPECT_NE(json.find("\"most_energy\""), std::string::npos);
    EXPECT_NE(json.find("\"paper_fps\": null"), std::string::npos);
}

}  // namespace
}  // namespace demolish::bullet
