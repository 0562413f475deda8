// SPDX-License-Identifier: Apache-2.0
// Session, hand shots, looks.
#include "tests/fuzz/shots/shot_run.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/glm.hpp>
#include <memory>

#include "app/commands/headless_stage.h"
#include "app/session/session.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/errors.h"
#include "tests/fuzz/shots/frame_checks.h"

namespace demolish::fuzz {
namespace {

using Clock = std::chrono::steady_clock;
constexpr uint64_t kHashes = 4;

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// Looks at a session without changing what it simulates.
class Watcher {
  public:
    Watcher(Session& session, const Watching& watching, ShotRun& run)
        : session_(session), watching_(watching), run_(run) {}

    void look(uint64_t frame) {
        if (frame % watching_.every != 0) return;
        if (watching_.measure) session_.solver().measure();
        if (watching_.frames) lookAtFrame(frame);
        if (watching_.restore) goAndComeBack();
        if (watching_.record) session_.setColour(colourOf(frame));
        static_cast<void>(session_.status());
    }

  private:
    static ParticleColour colourOf(uint64_t frame) { return static_cast<ParticleColour>(frame % 4); }

    void lookAtFrame(uint64_t frame) {
        const auto faults = faultsOfFrame(session_.built(), 0, colourOf(frame));
        for (const auto& fault : faults)
            run_.faults.push_back("frame " + std::to_string(frame) + ": " + fault);
    }
    void goAndComeBack() {
        Solver& solver = session_.solver();
        const uint64_t before = solver.stateHash();
        const Snapshot snapshot = solver.save();
        solver.advanceFrame(session_.shot().time_scale);
        solver.restore(snapshot);
        if (solver.stateHash() != before) run_.faults.emplace_back("a restored state has another hash");
    }

    Session& session_;
    const Watching& watching_;
    ShotRun& run_;
};

struct Ball {
    glm::dvec3 centre;
    double radius = 0;  ///< m
};

/// Round all bodies where the shot puts them, however they are turned.
Ball ballRoundBodies(const SceneSetup& setup) {
    glm::dvec3 low(1e300), high(-1e300);
    for (const BodyInstance& instance : setup.bodies) {
        const double reach = std::max(glm::length(toGlm(instance.body->bounds_min)),
                                      glm::length(toGlm(instance.body->bounds_max)));
        low = glm::min(low, toGlm(instance.position) - reach);
        high = glm::max(high, toGlm(instance.position) + reach);
    }
    return {0.5 * (low + high), 0.5 * glm::length(high - low)};
}

/// The target lies where the ball is still outside, as what a person clicks on does.
void fireByHand(const RandomShot& random, uint64_t frame, Session& session) {
    for (const HandShot& shot : random.by_hand) {
        if (shot.after_frame != frame) continue;
        const Ball ball = ballRoundBodies(session.built().setup);
        const glm::dvec3 side = glm::normalize(toGlm(shot.side)), target = ball.centre + ball.radius * side,
                         middle = ball.centre + ball.radius * toGlm(shot.astray);
        const glm::dvec3 from = target + 2 * ball.radius * glm::normalize(target - middle);
        session.apply(command::ShootAt{fromGlm(from), fromGlm(target)}, 0);
    }
}

void step(const RandomShot& random, const Watching& watching, Session& session, ShotRun& run) {
    Watcher watcher(session, watching, run);
    const uint64_t stretch = std::max<uint64_t>(1, random.frames / kHashes);
    for (uint64_t frame = 0; frame < random.frames; ++frame) {
        fireByHand(random, frame, session);
        const StepStatus status = session.advance();
        if (status != StepStatus::kOk) {
            run.stopped = describe(status);
            return;
        }
        run.frames = frame + 1;
        watcher.look(run.frames);
        if (run.frames % stretch == 0) run.hashes.push_back(session.solver().stateHash());
    }
}

void closeBooks(Session& session, ShotRun& run) {
    session.solver().measure();
    const EnergyBalance energy = session.energy();
    run.brought_in = energy.broughtIn();
    run.closure = energy.closure();
    run.weight_energy = session.solver().stats().mass * kGravity * session.built().shot.height;
}

}  // namespace

ShotRun runShot(const RandomShot& random, const Watching& watching) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, watching.threads);
    const auto begun = Clock::now();
    ShotRun run;
    try {
        BuiltShot built = buildShot(random.shot(),
                                    {.draw_geometry = watching.draw_geometry, .ledger = watching.ledger}, {});
        run.built_seconds = secondsSince(begun);
        run.faults = faultsOfBody(built);
        std::unique_ptr<HeadlessStage> stage;
        if (watching.record) stage = std::make_unique<HeadlessStage>(built.solver->onGpu());
        Session session(std::move(built), {.draw = watching.record, .record = watching.record});
        run.particles = session.solver().stats().particles;
        step(random, watching, session, run);
        run.broken = session.solver().stats().bonds_broken;
        if (watching.ledger && run.stopped.empty()) closeBooks(session, run);
        run.hashes.push_back(session.solver().stateHash());
    } catch (const Error& error) {
        run.refused = error.what();
    }
    run.seconds = secondsSince(begun);
    return run;
}

}  // namespace demolish::fuzz
