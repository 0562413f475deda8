// SPDX-License-Identifier: Apache-2.0
// Stepping, commands, replay.
#include "app/session/session.h"

#include <chrono>
#include <sstream>
#include <utility>

#include "app/session/ball_flight.h"
#include "app/session/model_shot.h"
#include "app/session/shot_geometry.h"
#include "app/session/shot_setup.h"
#include "engine/render/fracture_mesh.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/particle_colour.h"

namespace demolish {
namespace {

using Clock = std::chrono::steady_clock;

/// moved: m.
std::string setBackSentence(double moved) {
    std::ostringstream text;
    text.precision(3);
    text << "a ball would have started inside something and starts " << moved
         << " m farther back on its way; make it smaller or aim it from farther away";
    return text.str();
}

double msSince(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

}  // namespace

/// One overload a command.
struct Session::Obey {
    Session& session;
    double now;

    void operator()(const command::Play&) const { session.playing_ = true; }
    void operator()(const command::Pause&) const { session.playing_ = session.stepping_ = false; }
    void operator()(const command::TogglePlay&) const {
        session.playing_ = !session.playing_ && !std::exchange(session.stepping_, false);
    }
    void operator()(const command::Step&) const {
        session.playing_ = false;
        session.stepping_ = true;
        session.goOn();
    }
    void operator()(const command::Reset&) const { session.restart(); }
    void operator()(const command::Fire&) const { session.fireByHand(); }
    void operator()(const command::ShootAt& shot) const {
        if (session.wanted_.impact.velocity <= 0) {
            session.message_ = "nothing to shoot: the impact velocity is 0";
            return;
        }
        session.fire(makeBallAt(session.wanted_, *session.built_.body, shot.from, shot.target));
        ++session.fired_by_hand_;
        session.playing_ = true;
    }
    void operator()(const command::ChangeShot& changed) const { session.change(changed.shot, now); }
    void operator()(const command::CancelRebuild&) const {
        session.worker_.cancel();
        session.debounce_.clear();
        session.wantWhatIsBuilt();
    }
    void operator()(const command::MeasureEnergy& measure) const {
        Solver& solver = session.solver();
        session.measuring_ = measure.on;
        const bool booked = solver.booksEnergy();
        solver.bookEnergy(measure.on || session.built_.setup.params.ledger);
        if (!measure.on) return;
        booked ? solver.measure() : session.openBooks();
    }
    void operator()(const command::Scrub& scrub) const {
        session.playing_ = session.stepping_ = false;
        session.show(scrub.frame);
    }
};

Session::Session(BuiltShot built, const SessionOptions& options)
    : options_(options), wanted_(built.shot), recording_(options.memory_limit) {
    adopt(std::move(built));
}

void Session::adopt(BuiltShot built) {
    recording_.finishCopies();
    output_.reset();  // before its solver: it may hold registered buffers
    built_ = std::move(built);
    effects_ = built_.setup.params.effects;
    // What follows from the body's threshold is known only when the body is there.
    if (sameSubject(wanted_, built_.shot)) chooseVelocity(wanted_, *built_.body);
    if (wanted_.break_at && wanted_.break_at == built_.shot.break_at)
        wanted_.material.critical_velocity = built_.shot.material.critical_velocity;
    if (options_.draw) output_ = std::make_unique<FrameOutput>(built_);
    live_ = sameSubject(wanted_, built_.shot) ? wanted_ : built_.shot;
    restart();
}

Solver& Session::solver() {
    built_.solver->giveUpFrame();
    frame_share_.reset();
    under_way_ms_ = 0;
    return *built_.solver;
}

void Session::restart() {
    stepping_ = false;
    solver().bookEnergy(measuring_ || built_.setup.params.ledger);
    built_.solver->restore(built_.start);
    projectiles_ = static_cast<uint32_t>(built_.setup.projectiles.size());
    balls_started_.clear();
    fired_by_hand_ = 0;
    recording_.clear();
    message_.clear();
    startDueBalls();
    openBooks();
    bringFrame(true);
}

void Session::openBooks() {
    built_.solver->measure();
    start_energy_ = built_.solver->stats().energy;
    books_since_ = built_.solver->stats().time;
}

/// What is built, with the impact as it is chosen now: a change of its kind waits for the rebuild.
Shot Session::shotOfBalls() const {
    Shot shot = built_.shot;
    if (shot.impact.kind == wanted_.impact.kind) shot.impact = wanted_.impact;
    return shot;
}

/// Balls start between frames, so that the velocity chosen by then counts.
void Session::startDueBalls() {
    const Shot shot = shotOfBalls();
    const std::vector<TimedBall> balls = ballsOf(shot);
    const double now = built_.solver->stats().time, step = wanted_.time_scale / shot.fps;
    balls_started_.resize(balls.size(), false);
    for (size_t i = 0; i < balls.size(); ++i) {
        if (balls_started_[i] || !dueToStart(balls[i], now, step)) continue;
        const double remaining = balls[i].arrival_time - now;
        balls_started_[i] = true;
        if (remaining <= 0) continue;  // it was not to come then, and is late now
        const ThrownBall thrown = makeBall(shot, built_.setup, balls[i], remaining);
        balls_started_[i] = thrown.flight > remaining - step;  // else it must start later, nearer to the body
        if (balls_started_[i]) fire(thrown.ball);
    }
}

/// The shot's balls one after the other, over and over, now.
void Session::fireByHand() {
    const Shot shot = shotOfBalls();
    const std::vector<TimedBall> balls = ballsOf(shot);
    if (balls.empty()) {
        message_ = "nothing to fire: the impact velocity is 0 or the body is dropped";
        return;
    }
    const TimedBall& ball = balls[fired_by_hand_++ % balls.size()];
    fire(makeBall(shot, built_.setup, ball, ball.flight_time).ball);
    playing_ = true;
}

/// Live values stay as chosen; those that would need a rebuild go back. Of a scene or model that does not
/// come nothing stays.
void Session::wantWhatIsBuilt() {
    if (sameSubject(wanted_, built_.shot)) live_ = wanted_;
    Shot shot = built_.shot;
    if (shot.impact.kind == live_.impact.kind && shot.impact.kind != ImpactKind::kDrop)
        shot.impact = live_.impact;
    shot.time_scale = live_.time_scale;
    shot.lighting = live_.lighting;
    shot.effects = live_.effects;
    shot.environment = live_.environment;
    shot.lens = live_.lens;
    wanted_ = std::move(shot);
}

/// A new velocity acts on the impact that is still to come.
void Session::restartIfNotHit() {
    const auto balls = ballsOf(wanted_);
    const double first_impact = balls.empty() ? wanted_.impact.arrival_time : balls[0].arrival_time;
    if (fired_by_hand_ == 0 && shown_.bonds_broken == 0 && shown_.time < first_impact) {
        const bool was_playing = playing_;
        restart();
        playing_ = was_playing;
    }
}

void Session::fire(const Projectile& ball) {
    try {
        if (!atEnd()) show(newest_);
        const double moved = solver().fire(ball);
        ++projectiles_;
        if (moved > 0) message_ = setBackSentence(moved);
    } catch (const UsageError& error) {
        message_ = error.what();
    }
}

void Session::bringFrame(bool fresh) {
    shown_ = built_.solver->stats();
    if (!output_) return;
    recording_.finishCopies();
    RecordedFrame frame;
    FrameTap tap;
    if (options_.record && !recording_.full())
        tap = [&](FrameChange change, const ReadStream& read, const ColourBytes& colours) {
            frame = recording_.read(change, read, colours, shown_,
                                    built_.solver->exportSizes().exterior_vertices);
        };
    FrameBridge& bridge = output_->bridge();
    const auto begun = Clock::now();
    bridge.transfer(*built_.solver, {colour_, projectiles_, fresh, tap});
    spheres_ = spheresOf(bridge.projectiles());
    last_transfer_ms_ = msSince(begun);
    newest_ = recording_.size();
    cursor_ = newest_;
    if (!tap) return;
    frame.projectiles.assign(bridge.projectiles().begin(), bridge.projectiles().end());
    recording_.add(std::move(frame));
}

/// Amounts act from the next frame on; room for grains and puffs, and how fine they are, as built.
void Session::followEffects() {
    if (!output_) return;
    const EffectsSettings& built = built_.setup.params.effects;
    EffectsSettings wanted = wanted_.effects;
    wanted.finest = built.finest;
    wanted.grains = built.grains;
    wanted.puffs = built.puffs;
    if (wanted == effects_) return;
    built_.solver->setEffects(wanted);
    effects_ = wanted;
}

StepStatus Session::advance(const FrameWatch& watch) {
    const auto begun = Clock::now();
    if (!frame_share_) {
        followEffects();
        startDueBalls();
    }
    const auto looked_at = [&](double share) {
        frame_share_ = share;
        return watch(share);
    };
    const ExpectedTransfer expected(output_ ? &output_->bridge() : nullptr);
    const StepStatus status =
        built_.solver->advanceFrame(wanted_.time_scale, watch ? FrameWatch(looked_at) : FrameWatch{});
    built_.solver->synchronize();
    under_way_ms_ += msSince(begun);
    if (built_.solver->frameUnfinished()) return status;
    frame_share_.reset();
    stepping_ = false;
    last_sim_ms_ = std::exchange(under_way_ms_, 0);
    if (status != StepStatus::kOk) {
        playing_ = false;
        message_ = describe(status);
        shown_.status = status;
        return status;
    }
    if (measuring_) built_.solver->measure();
    bringFrame(false);
    return status;
}

void Session::apply(const command::Any& command, double now) {
    std::visit(Obey{*this, now}, command);
}

void Session::update(double now, bool may_step) {
    if (auto shot = debounce_.take(now)) worker_.start(*shot, built_);
    takeRebuild();
    last_sim_ms_ = last_transfer_ms_ = 0;
    const bool due = may_step || frame_share_;
    if (stepping_ || (playing_ && due)) goOn();
}

/// To the next frame that is recorded, or as far towards the next one as a turn of the window allows.
void Session::goOn() {
    if (!atEnd()) {
        stepping_ = false;
        show(cursor_ + 1);
        return;
    }
    const auto begun = Clock::now();
    advance([begun](double) { return msSince(begun) < 1000 * kLongestTurn; });
}

void Session::show(size_t frame) {
    if (!output_ || frame > newest_) return;
    recording_.finishCopies();
    cursor_ = frame;
    last_sim_ms_ = last_transfer_ms_ = 0;
    if (atEnd()) {
        // Replayed frames have overwritten it, perhaps in another colour: stepping goes on from it.
        output_->bridge().transfer(solver(), {colour_, projectiles_, true});
        spheres_ = spheresOf(output_->bridge().projectiles());
        shown_ = built_.solver->stats();
        return;
    }
    recording_.replay(frame, output_->mesh(), built_.setup, colour_);
    const RecordedFrame& recorded = recording_.frame(frame);
    spheres_ = spheresOf(recorded.projectiles);
    shown_ = recorded.stats;
}

void Session::change(const Shot& shot, double now) {
    try {
        validate(shot);
    } catch (const UsageError& error) {
        message_ = error.what();
        return;
    }
    const Change since_wanted = changeBetween(wanted_, shot);
    if (sameSubject(wanted_, built_.shot)) live_ = wanted_;
    wanted_ = shot;
    Shot fired = shot;
    chooseVelocity(fired, *built_.body);
    const bool steps_change = takesOtherSteps(fired, built_.setup);
    if (steps_change || changeBetween(built_.shot, shot) >= Change::kSolver) {
        const bool asks_anew = since_wanted >= (steps_change ? Change::kLive : Change::kSolver);
        if (asks_anew || debounce_.waiting()) debounce_.push(shot, now);
        return;
    }
    debounce_.clear();
    worker_.cancel();
    wanted_ = std::move(fired);
    if (since_wanted >= Change::kLive) restartIfNotHit();
}

void Session::takeRebuild() {
    try {
        auto built = worker_.take();
        if (!built) return;
        const bool was_playing = playing_;
        adopt(std::move(*built));
        playing_ = was_playing;
    } catch (const std::exception& error) {
        message_ = error.what();
        wantWhatIsBuilt();
    }
}

void Session::setColour(ParticleColour colour) {
    if (colour == colour_) return;
    colour_ = colour;
    if (!output_) return;
    recording_.finishCopies();
    if (atEnd())
        output_->bridge().transfer(solver(), {colour_, projectiles_, false});
    else
        show(cursor_);
}

const char* Session::transfer() const {
    return output_ ? transferName(output_->bridge().kind()) : "none";
}

SessionStatus Session::status() const {
    SessionStatus status;
    status.stats = shown_;
    status.softening = built_.solver->softening();
    status.device = built_.solver->deviceName();
    status.transfer = transfer();
    if (output_) status.transfer_note = output_->bridge().note();
    status.on_gpu = built_.solver->onGpu();
    status.measuring = measuring_;
    if (measuring_ && atEnd()) status.energy = energy();
    status.playing = playing();
    status.replaying = !atEnd();
    status.frame_share = frame_share_;
    status.cursor = cursor_;
    status.newest = newest_;
    status.recorded_frames = recording_.size();
    status.recorded_bytes = recording_.bytes();
    status.memory_limit = recording_.memoryLimit();
    const uint32_t done = built_.solver->stats().substeps;  // 0 before the first frame
    status.substeps_per_frame = done > 0 ? done : built_.setup.params.substeps;
    status.bodies = built_.setup.bodies.size();
    status.particle_size = built_.body->spacing;
    status.body_volume = built_.body->mesh_volume;
    const glm::dvec3 extent = toGlm(built_.body->bounds_max) - toGlm(built_.body->bounds_min);
    status.body_size = sizeToScale(fromGlm(extent));
    status.size_remark =
        sizeRemark(built_.shot, built_.body->bounds_min, built_.body->bounds_max, Advised::kWindow);
    status.full_colour_speed = speedOfFullColour(built_.setup);
    status.build_seconds = built_.build_seconds;
    status.repair = repairSentence(repairReport(*built_.cells.subject_mesh));
    status.looks = modelLooks(*built_.cells.subject_mesh);
    status.waiting = debounce_.waiting();
    status.rebuilding = worker_.busy();
    status.rebuild = worker_.progress();
    status.message = message_;
    return status;
}

}  // namespace demolish
