// SPDX-License-Identifier: Apache-2.0
// bullet_bench SCENE PARTICLES: the scene's bodies in preset pieces, as --method pattern cuts them, moved by
// Bullet to the end of the scene's last phase. A row of Markdown: ms a frame whole and broken, without
// drawing, pieces, and the most energy found over what there was and what came in.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "app/compare/method_row.h"
#include "app/session/ball_flight.h"
#include "app/session/scene_file.h"
#include "tests/bullet/bullet_world.h"

namespace {

using namespace demolish;

struct Times {
    std::vector<double> whole, broken;  ///< ms
    double most_energy = 0, energy_in = 0;
};

/// Fires each ball when it is due.
class Balls {
  public:
    Balls(const Shot& shot, const SceneSetup& setup)
        : shot_(shot), setup_(setup), balls_(ballsOf(shot)), started_(balls_.size(), false) {}

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

double kinetic(const Projectile& ball) {
    const Double3& v = ball.velocity;
    const double mass = ball.density * 4.18879020478639 * ball.radius * ball.radius * ball.radius;
    return mass * ((v.x * v.x + v.y * v.y + v.z * v.z) / 2 + 9.81 * ball.position.y);
}

Times run(const BuiltShot& built, bullet::World& world, double end) {
    Times times;
    Balls balls(built.shot, built.setup);
    times.energy_in = world.energy();
    const double frame = 1 / built.shot.fps;
    for (double now = 0; now < end; now += frame) {
        balls.startDue(now, [&](const Projectile& ball) {
            world.fire(ball);
            times.energy_in += kinetic(ball);
        });
        const auto begun = std::chrono::steady_clock::now();
        world.advance(frame);
        const double ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
        const Phase* phase = phaseAt(built.shot.phases, now + frame);
        if (phase == &built.shot.phases.front()) times.whole.push_back(ms);
        if (phase == &built.shot.phases.back()) times.broken.push_back(ms);
        times.most_energy = std::max(times.most_energy, world.energy());
    }
    return times;
}

void printRow(const char* scene, uint32_t particles) {
    Shot shot = loadScene(scene);
    shot.model = shot.paper_model.value_or(shot.model);
    shot.device = DeviceChoice::kCpu;
    shot.method = Method::kPattern;
    shot.effects.on = false;
    shot.fineness.particles = particles;
    if (shot.phases.empty()) throw std::runtime_error("the scene has no phases");
    const double end = shot.phases.back().to;
    Session session(buildShot(shot, {}, {}), {.draw = false});
    while (session.solver().stats().time < end)
        if (session.advance() != StepStatus::kOk) throw std::runtime_error("a step failed");
    bullet::World world(bullet::piecesOf(session.built().setup, fragmentMap(session)));
    const Times times = run(session.built(), world, end);
    std::printf("| %s, %u | %.2f | %.2f | %zu | %.3f |\n", scene, particles, quantile(times.whole, 0.5),
                quantile(times.broken, 0.5), world.pieces(), times.most_energy / times.energy_in);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) {
        std::fputs("usage: bullet_bench SCENE PARTICLES\n", stderr);
        return 2;
    }
    printRow(argv[1], static_cast<uint32_t>(std::strtoul(argv[2], nullptr, 10)));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
