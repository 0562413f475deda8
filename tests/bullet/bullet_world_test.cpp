// SPDX-License-Identifier: Apache-2.0
#include "tests/bullet/bullet_world.h"

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

}  // namespace
}  // namespace demolish::bullet
