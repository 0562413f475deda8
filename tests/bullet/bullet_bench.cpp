// SPDX-License-Identifier: Apache-2.0
// bullet_bench SCENE PARTICLES [FOLDER MOMENTS WxH]: the scene's bodies in preset pieces, as --method pattern
// cuts them, moved by Bullet to the end of the scene's last phase. A row of Markdown: ms a frame whole and
// broken, without drawing, pieces, and the most energy found over what there was and what came in. Pictures
// of the moments (s, with commas) go into the folder.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/shot_options.h"
#include "app/compare/method_row.h"
#include "app/session/ball_flight.h"
#include "sim_cuda/api/errors.h"
#include "tests/bullet/bullet_pictures.h"

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

/// seen(time): after each frame, and before the first.
template <class Seen>
Times run(const BuiltShot& built, bullet::World& world, double end, const Seen& seen) {
    Times times;
    seen(0.0);
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
        seen(now + frame);
    }
    return times;
}

struct Arguments {
    ShotOptions shot;
    std::string folder;
    std::vector<double> moments;  ///< s, ascending
};

Arguments argumentsOf(int argc, char** argv) {
    if (argc != 3 && argc != 6) throw UsageError("usage: bullet_bench SCENE PARTICLES [FOLDER MOMENTS WxH]");
    Arguments arguments;
    arguments.shot.scene = argv[1];
    arguments.shot.particles = std::strtod(argv[2], nullptr);
    arguments.shot.device = "cpu";
    arguments.shot.method = "pattern";
    arguments.shot.effects = "off";
    if (argc == 3) return arguments;
    arguments.folder = argv[3];
    std::istringstream moments(argv[4]);
    for (std::string moment; std::getline(moments, moment, ',');)
        arguments.moments.push_back(std::strtod(moment.c_str(), nullptr));
    arguments.shot.size = argv[5];
    return arguments;
}

void printRow(const Arguments& arguments) {
    const Shot shot = makeShot(arguments.shot, "paper");
    if (shot.phases.empty()) throw std::runtime_error("the scene has no phases");
    const double end = shot.phases.back().to;
    const bool draws = !arguments.folder.empty();
    std::optional<HeadlessStage> stage;
    if (draws) stage.emplace(false);
    Session session(buildShot(shot, {}, {}), {.draw = draws});
    while (session.solver().stats().time < end)
        if (session.advance() != StepStatus::kOk) throw std::runtime_error("a step failed");
    const std::vector<bullet::Piece> pieces = bullet::piecesOf(session.built().setup, fragmentMap(session));
    bullet::World world(pieces);
    const PictureSize size = pictureSize(arguments.shot, {640, 360});
    std::optional<bullet::Pictures> pictures;
    if (draws)
        pictures.emplace(session, *stage, arguments.folder, size.width, size.height,
                         arguments.moments.size());
    size_t drawn = 0;
    const Times times = run(session.built(), world, end, [&](double time) {
        if (drawn == arguments.moments.size() || time < arguments.moments[drawn] - 0.5 / shot.fps) return;
        pictures->draw(world, pieces);
        ++drawn;
    });
    if (draws) pictures->finish();
    std::printf("| %s, %u | %.2f | %.2f | %zu | %.3f |\n", shot.scene.c_str(),
                session.solver().stats().particles, quantile(times.whole, 0.5), quantile(times.broken, 0.5),
                world.pieces(), times.most_energy / times.energy_in);
}

}  // namespace

int main(int argc, char** argv) try {
    printRow(argumentsOf(argc, argv));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
