// SPDX-License-Identifier: Apache-2.0
// Set-up of one body, its ball or its fall, and the criterion.
#include "app/calibrate/impact_trial.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "app/bridge/host_frame.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_setup.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kFrameTime = 1.0 / 60;  // s
constexpr double kFlight = 0.004;     // s before the ball meets the surface: clear of a body that has sagged
constexpr double kClear = 1.2;        // of what particles reach beyond the surface
constexpr double kMostFlight = 0.02;  // s: a longer one is so bent by gravity that it leads through the body
constexpr int kQuietFrames = 6;       // 0.1 s without a bond that breaks: what holds until then has held
constexpr int kMostFrames = 60;       // 1 s
constexpr double kMostDelay = 0.1;    // s, of a ball so slow that it creeps up to the first particle

bool isDrop(const Shot& shot) {
    return shot.impact.kind == ImpactKind::kDrop;
}

/// m. In a thin wall particles touch as spheres of half the distance to the next one, wider than the wall: a
/// slow ball that is placed at the surface would start inside them, and be shot away by what it presses on.
double reachBeyondSurface(const BreakableBody& body) {
    std::vector<double> radius(body.particles.size(), 0.0);
    for (const BondGeometry& bond : body.bonds)
        for (const uint32_t end : {bond.i, bond.j})
            if (!(radius[end] > 0) || bond.length < 2 * radius[end]) radius[end] = bond.length / 2;
    double reach = 0;
    for (size_t i = 0; i < radius.size(); ++i) reach = std::max(reach, radius[i] - body.particles[i].depth);
    return reach;
}

}  // namespace

double trialSeconds(ImpactKind kind, double height, double speed) {
    const double path = (kind == ImpactKind::kDrop ? 0.5 : 2) * height;
    return std::clamp(path / speed, kLeastTrial, kLongestTrial);
}

Shot trialShot(const Shot& shot) {
    Shot trial = shot;
    const TimedBall ball = fastestBall(shot);
    SceneBody place = bodiesOf(shot)[isDrop(shot) ? subjectOf(shot) : ball.body];
    place.position = {};
    place.velocity = place.spin = {};
    place.variant = 0;
    trial.bodies = {place};
    trial.balls = {ball};
    trial.balls[0].body = 0;
    trial.phases.clear();
    trial.method = Method::kOurs;  // the threshold is that of the bonds
    trial.hand_over = trial.sleeping = false;
    trial.fps = 1 / kFrameTime;
    trial.time_scale = 1;
    return trial;
}

ImpactTrial::ImpactTrial(const Shot& shot, std::shared_ptr<const BreakableBody> body,
                         const TrialOptions& options, const ProgressCallback& progress)
    : shot_(shot), options_(options) {
    shot_.impact.velocity = 1;  // above 0, so that a drop is set up as one; every trial has its own
    setup_ = makeSetup(shot_, {std::move(body)});
    beyond_ = reachBeyondSurface(*setup_.bodies[0].body);
    setup_.params.ledger = false;
    setup_.params.substeps *= options.finer_steps;
    setup_.params.step_safety /= options.finer_steps;
    if (isDrop(shot_)) {
        setup_.params.gravity = {};
        return;
    }
    solver_ = makeSolver(progress);
    start_ = solver_->save();
}

std::unique_ptr<Solver> ImpactTrial::makeSolver(const ProgressCallback& progress) const {
    return options_.on_gpu ? makeCudaSolver(setup_, progress) : makeCpuSolver(setup_, progress);
}

/// The lowest point just touches: what the shot shows of the fall before is not simulated.
void ImpactTrial::placeAboveFloor(double speed) {
    BodyInstance& instance = setup_.bodies[0];
    const Quaternion& q = instance.rotation;
    const glm::dquat rotation(q.w, q.x, q.y, q.z);
    double lowest = 1e300;
    for (const Particle& particle : instance.body->particles)
        lowest =
            std::min(lowest, (rotation * glm::dvec3(particle.seed.x, particle.seed.y, particle.seed.z)).y -
                                 particle.depth);
    instance.position.y = -lowest;
    instance.velocity = {0, -speed, 0};
}

ThrownBall ImpactTrial::ballAt(double speed) const {
    Shot shot = shot_;
    shot.impact.velocity = speed;
    const double flight = std::clamp(kClear * beyond_ / speed, kFlight, kMostFlight);
    return makeBall(shot, setup_, shot.balls[0], flight);
}

bool ImpactTrial::breaksAt(double speed) {
    const bool drop = isDrop(shot_);
    std::unique_ptr<Solver> dropped;
    double flight = 0;
    if (drop) {
        placeAboveFloor(speed);
        dropped = makeSolver({});
    } else {
        solver_->restore(start_);
        const ThrownBall thrown = ballAt(speed);
        solver_->fire(thrown.ball);
        flight = thrown.flight;
    }
    Solver& solver = drop ? *dropped : *solver_;
    // Particles touch as spheres inside their cells: up to half a spacing later than the surface does.
    const double gap = 0.5 * setup_.bodies[0].body->spacing;
    const double delay = std::min(kMostDelay, gap / std::max(speed, 1e-3)) + flight;
    const BreakableBody& body = *setup_.bodies[0].body;
    const double seconds =
        trialSeconds(shot_.impact.kind, body.bounds_max.y - body.bounds_min.y, speed) + delay;
    const int frames = static_cast<int>(std::lround(seconds / kFrameTime));
    for (int frame = 0, broke = 0; frame < frames || (frame < kMostFrames && frame - broke < kQuietFrames);
         ++frame) {
        const StepStatus status = solver.advanceFrame();
        if (status != StepStatus::kOk) throw NumericalError(describe(status));
        simulated_ += kFrameTime;
        if (broken(solver)) return true;
        if (solver.stats().fracture_changed) broke = frame + 1;
    }
    return false;
}

bool ImpactTrial::broken(Solver& solver) const {
    if (!(solver.stats().largest_fragment_fraction < kIntactShare)) return false;
    if (solver.stats().largest_fragment_fraction < kCrushedShare) return true;
    const BreakableBody& body = *setup_.bodies[0].body;
    const std::vector<uint32_t> fragment = readFrame(solver, FrameParts::kFragments).particle_fragment;
    std::map<uint32_t, double> volume;
    double whole = 0;
    for (size_t i = 0; i < body.particles.size(); ++i) {
        volume[fragment[i]] += body.particles[i].volume;
        whole += body.particles[i].volume;
    }
    return std::count_if(volume.begin(), volume.end(),
                         [&](const auto& piece) { return piece.second >= kPieceShare * whole; }) >= 2;
}

double ImpactTrial::bodyMass() const {
    double volume = 0;
    for (const Particle& particle : setup_.bodies[0].body->particles) volume += particle.volume;
    return setup_.bodies[0].material.density * volume;
}

double ImpactTrial::ballMass() const {
    if (isDrop(shot_)) return 0;
    const Projectile ball = ballAt(1).ball;
    return ball.density * 4.0 / 3 * 3.14159265358979323846 * ball.radius * ball.radius * ball.radius;
}

}  // namespace demolish
