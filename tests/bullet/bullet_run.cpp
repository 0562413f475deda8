// SPDX-License-Identifier: Apache-2.0
#include "tests/bullet/bullet_run.h"

#include <LinearMath/btScalar.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "app/commands/bench_run.h"
#include "app/commands/interrupt.h"
#include "app/session/ball_flight.h"
#include "sim_cuda/api/errors.h"
#include "tests/bullet/bullet_pictures.h"

namespace demolish::bullet {
namespace {

/// Fires each ball when it is due.
class Balls {
  public:
    Balls(const Shot& shot, const SceneSetup& setup)
        : shot_(shot), setup_(setup), balls_(demolish::ballsOf(shot)), started_(balls_.size(), false) {}

    template <class Fire>
    void startDue(double now, const Fire& fire) {
        for (size_t i = 0; i < balls_.size(); ++i) {
            if (started_[i] || !dueToStart(balls_[i], now, 1 / shot_.fps)) continue;
            started_[i] = true;
            fire(makeBall(shot_, setup_, balls_[i], balls_[i].arrival_time - now).ball);
        }
    }

  private:
    const Shot& shot_;
    const SceneSetup& setup_;
    std::vector<TimedBall> balls_;
    std::vector<bool> started_;
};

/// J, kinetic and potential.
double energyOf(const Projectile& ball) {
    const Double3& v = ball.velocity;
    const double mass = ball.density * 4 / 3 * std::numbers::pi * ball.radius * ball.radius * ball.radius;
    return mass * ((v.x * v.x + v.y * v.y + v.z * v.z) / 2 + 9.81 * ball.position.y);
}

BuildOptions optionsFor(bool draw, const BuiltShot* reuse) {
    return {.draw_geometry = draw, .ledger = false, .reuse = reuse};
}

}  // namespace

CutScene cutScene(BuiltShot built, uint64_t frames, bool draw) {
    CutScene cut;
    cut.session = std::make_unique<Session>(std::move(built), SessionOptions{.draw = draw});
    for (uint64_t frame = 0; frame < frames; ++frame) {
        requireOk(cut.session->advance());
        if (InterruptWatch::asked()) throw Interrupted("interrupted; nothing was measured");
    }
    cut.map = fragmentMap(*cut.session);
    cut.pieces = piecesOf(cut.session->built().setup, cut.map);
    return cut;
}

BulletRun runInBullet(const BuiltShot& built, std::span<const Piece> pieces, uint64_t frames,
                      const Drawn& drawn) {
    BulletRun run;
    World world(pieces);
    Balls balls(built.shot, built.setup);
    double energy_in = world.energy();
    const double step = 1 / built.shot.fps;
    for (uint64_t frame = 0; frame < frames; ++frame) {
        balls.startDue(static_cast<double>(frame) * step, [&](const Projectile& ball) {
            world.fire(ball);
            energy_in += energyOf(ball);
        });
        FrameSample sample;
        sample.stats.time = static_cast<double>(frame + 1) * step;
        const StopWatch watch;
        world.advance(step);
        sample.sim_ms = watch.milliseconds();
        if (drawn) drawn(world, sample.stats.time);
        sample.frame_ms = watch.milliseconds();
        run.samples.push_back(sample);
        run.most_energy = std::max(run.most_energy, world.energy());
    }
    run.most_energy /= energy_in;
    return run;
}

MethodRow bulletRow(const Shot& shot, const ShotOptions& options, PictureSize size, MethodsPlace& place) {
    const bool draws = size.width > 0;
    BuiltShot built = buildShot(shot, optionsFor(draws, nullptr), {});
    std::optional<BenchStage> stage;
    if (draws) stage.emplace(choosesCuda(shot), built, options, size);
    CutScene cut = cutScene(std::move(built), place.frames, draws);
    const BuiltShot& cells = cut.session->built();
    const BulletRun run = runInBullet(cells, cut.pieces, place.frames, [&](const World& world, double) {
        if (!draws) return;
        placePieces(*cut.session, world, cut.pieces);
        stage->draw(cut.session->mesh(), ballsOf(world));
    });
    MethodRow row;
    row.name = "bullet";
    row.device = "Bullet " + std::to_string(btGetVersion() / 100) + "." +
                 std::to_string(btGetVersion() % 100) + ", one thread";
    addTimes(run.samples, shot.phases, row);
    row.most_energy = run.most_energy;
    row.sizes = pieceSizes(cut.map);
    if (draws) row.outline = outlineOf(*cut.session);
    Shot other = turnedImpact(shot, *cells.body);
    other.fineness.particles = static_cast<uint32_t>(cells.body->particles.size());
    const CutScene turned = cutScene(buildShot(other, optionsFor(draws, &cells), {}), place.frames, false);
    row.moved = mapDistance(cut.map, turned.map);
    row.turned_pieces = turned.pieces.size();
    place.particles = cut.session->solver().stats().particles;
    place.bodies = static_cast<uint32_t>(cells.setup.bodies.size());
    if (draws) place.tellDrawnBy(stage->info().renderer, size);
    return row;
}

}  // namespace demolish::bullet
