// SPDX-License-Identifier: Apache-2.0
// A scene in Bullet, as a row beside our methods.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "app/commands/methods_bench.h"
#include "tests/bullet/bullet_world.h"

namespace demolish::bullet {

/// A scene whose bodies are in preset pieces, as --method pattern cuts them.
struct CutScene {
    std::unique_ptr<Session> session;  ///< at the end of the scene
    std::vector<uint32_t> map;         ///< the piece of every cell
    std::vector<Piece> pieces;         ///< where they stand at the start
};
/// Runs the shot, of Method::kPattern, to the end of its frames. Throws NumericalError, Interrupted.
CutScene cutScene(BuiltShot built, uint64_t frames, bool draw);

/// After each frame: the world, and what has been simulated by then, s. What it takes counts as drawing.
using Drawn = std::function<void(const World& world, double time)>;

struct BulletRun {
    std::vector<FrameSample> samples;  ///< frame, sim, and the time at the end
    double most_energy = 0;            ///< after any frame, over what there was and what the balls brought in
};
/// Fires the shot's balls at pieces that stand, frame by frame.
BulletRun runInBullet(const BuiltShot& built, std::span<const Piece> pieces, uint64_t frames,
                      const Drawn& drawn = {});

/// The same numbers as for our methods, of the same cells; pieces, their outlines and whether they follow the
/// impact by how they are cut. Without drawing where `size` is of no width; else `options` say how. Fills in
/// the place. Throws as cutScene() and buildShot().
MethodRow bulletRow(const Shot& shot, const ShotOptions& options, PictureSize size, MethodsPlace& place);

}  // namespace demolish::bullet
