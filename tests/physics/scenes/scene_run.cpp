// SPDX-License-Identifier: Apache-2.0
// Scenes for tests: fewer bodies, fewer particles, the same everything else.
#include "tests/physics/scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/session/scene_file.h"

namespace demolish::tests {
namespace {

double distance(const Float3& a, const Float3& b) {
    return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

void keepOnly(const std::vector<uint32_t>& kept, Shot& shot) {
    std::vector<SceneBody> bodies;
    for (const uint32_t body : kept) bodies.push_back(shot.bodies.at(body));
    std::vector<TimedBall> balls;
    for (TimedBall ball : shot.balls) {
        const auto at = std::find(kept.begin(), kept.end(), ball.body);
        if (at == kept.end()) continue;
        ball.body = static_cast<uint32_t>(at - kept.begin());
        balls.push_back(ball);
    }
    shot.bodies = bodies;
    shot.balls = balls;
}

BuiltShot built(const Shot& shot, const SceneRunOptions& options) {
    BuiltShot built = buildShot(shot, {.draw_geometry = false, .ledger = options.ledger}, {});
    if (options.in_free_space) {
        SolverParams& params = built.setup.params;
        params.gravity = {};
        params.colliders.clear();
        params.settle_time = 0;
        built.solver = makeCpuSolver(built.setup);
        built.start = built.solver->save();
    }
    return built;
}

}  // namespace

Shot smallScene(const std::string& name, uint32_t particles, const std::vector<uint32_t>& kept) {
    Shot shot = loadScene(name);
    shot.model = shot.paper_model.value_or(shot.model);
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = particles;
    if (!kept.empty()) keepOnly(kept, shot);
    return shot;
}

void bringForward(Shot& shot, const ImpactTimes& times) {
    shot.impact.arrival_time = times.first;
    if (shot.balls.empty()) return;
    const double first = shot.balls.front().arrival_time, last = shot.balls.back().arrival_time;
    const double shrink = last > first ? (times.last - times.first) / (last - first) : 0;
    for (TimedBall& ball : shot.balls) ball.arrival_time = times.first + shrink * (ball.arrival_time - first);
}

SceneRun::SceneRun(const Shot& shot, const SceneRunOptions& options)
    : session_(built(shot, options), {.draw = false}) {}

void SceneRun::runTo(double time) {
    while (stats().time < time - 1e-6) ASSERT_EQ(session_.advance(), StepStatus::kOk);
}

const FrameStats& SceneRun::measured() {
    session_.solver().measure();
    return session_.solver().stats();
}

EnergyBalance SceneRun::energy() {
    session_.solver().measure();
    return session_.energy();
}

std::vector<uint32_t> SceneRun::fragments() {
    std::vector<uint32_t> fragments(streamSizes(setup()).particles);
    RenderStreams streams;
    streams.particle_fragment = {fragments.data(), fragments.size()};
    session_.solver().exportFrame(streams, true);
    fragments.resize(stats().particles);
    return fragments;
}

std::vector<Float3> SceneRun::positions() {
    std::vector<ParticleInstance> particles(streamSizes(session_.built().setup).particles);
    RenderStreams streams;
    streams.particles = {particles.data(), particles.size()};
    session_.solver().exportFrame(streams);
    std::vector<Float3> positions;
    for (uint32_t i = 0; i < stats().particles; ++i) positions.push_back(particles[i].position);
    return positions;
}

std::vector<double> SceneRun::speeds() {
    const auto before = positions();
    const double begun = stats().time;
    EXPECT_EQ(session_.advance(), StepStatus::kOk);
    const auto after = positions();
    std::vector<double> speeds;
    for (size_t i = 0; i < after.size(); ++i)
        speeds.push_back(distance(before[i], after[i]) / (stats().time - begun));
    return speeds;
}

double SceneRun::rootMeanSquareSpeed() {
    double sum = 0;
    const std::vector<double> all = speeds();
    for (const double speed : all) sum += speed * speed;
    return std::sqrt(sum / static_cast<double>(all.size()));
}

double SceneRun::movingShare(double speed) {
    const std::vector<double> all = speeds();
    const auto moving = std::count_if(all.begin(), all.end(), [speed](double v) { return v > speed; });
    return static_cast<double>(moving) / static_cast<double>(all.size());
}

Standing stand(Shot shot, double seconds) {
    constexpr double kLook = 0.1;  // s, or what sways may be back where it began
    shot.impact.kind = ImpactKind::kNone;
    shot.sleeping = shot.hand_over = false;
    SceneRun run(shot);
    const auto start = run.positions();
    Standing standing;
    for (double time = std::min(kLook, seconds); time < seconds + 0.5 * kLook; time += kLook) {
        run.runTo(time);
        standing.moved = std::max(standing.moved, farthest(start, run.positions()));
    }
    standing.broken = run.stats().bonds_broken;
    standing.speed = run.rootMeanSquareSpeed();
    return standing;
}

double farthest(const std::vector<Float3>& from, const std::vector<Float3>& to) {
    double most = 0;
    for (size_t i = 0; i < from.size(); ++i) most = std::max(most, distance(from[i], to[i]));
    return most;
}

}  // namespace demolish::tests
