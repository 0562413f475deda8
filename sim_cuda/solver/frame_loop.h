// SPDX-License-Identifier: Apache-2.0
// A frame as a loop over stretches of substeps:
//
//   set the state aside -> how each fragment is moved
//   -> [ substeps of bonds, contact steps of rigid fragments -> look at the state -> the same once more
//        -> contact lists again, if the look said so; then again how each fragment is moved ] ...
//   -> last look
//
// A look and the decision that follows it stand at fixed substeps, so that every device takes the same one;
// the substeps between them hide the way of the answer from the GPU. If a look saw something bad, the state
// set aside is put back. Between two stretches a frame may be left, and gone on with later.
#pragma once
#include <algorithm>
#include <optional>
#include <utility>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/solver/checkpoint.h"
#include "sim_cuda/solver/contact_steps.h"
#include "sim_cuda/solver/decisions.h"
#include "sim_cuda/solver/list_schedule.h"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/loop_state.h"
#include "sim_cuda/solver/state_look.h"
#include "sim_cuda/solver/stray_paths.h"

namespace demolish {

/// Owns what decides the order of the work: when lists are built, regimes decided, looks taken.
template <class Backend, class Real>
class FrameLoop {
  public:
    using Scene = DeviceScene<Backend, Real>;

    struct Frame {
        StepStatus status = StepStatus::kOk;
        bool quiet = false;     ///< everything slept: nothing has changed but the time
        uint32_t substeps = 0;  ///< of the whole frame; 0: it is unfinished
        uint32_t list_rebuilds = 0;
    };

    /// Keeps references to both.
    FrameLoop(Scene& scene, Projectiles& projectiles)
        : scene_(scene),
          projectiles_(projectiles),
          lists_(scene.tables.time_step),
          decisions_(scene),
          stepper_(scene.backend),
          look_(scene.backend),
          strays_(scene.backend) {}

    /// A frame of n substeps, or the rest of an unfinished one of any number, as far as `watch` wants. After
    /// a bad status everything is as it was.
    Frame advance(uint32_t n, const FrameWatch& watch);
    bool frameUnfinished() const { return frame_.has_value(); }
    /// Sets the state aside and decides how each fragment is moved in a frame of n substeps.
    void beginFrame(uint32_t n);
    /// Everything is as it was before an unfinished frame.
    void giveUpFrame();
    /// Substeps of the last frame, whose state has been put back without what was decided for it; else 0.
    uint32_t undecidedFrame() const {
        const auto& regimes = scene_.regimes;
        return frame_ || !regimes.on() || regimes.listsStand() ? 0 : decisions_.lastFrame();
    }
    /// One stretch, of substeps, and nothing around it.
    StepStatus runStretch(const Stretch& part);
    /// Those whose time has come take part from now on.
    void startProjectiles();
    /// use() with contact lists that are good for the present state; those of the run stay, and with them
    /// when they are made anew.
    template <class Use>
    void withGoodLists(const Use& use);
    Stepper<Backend, Real>& stepper() { return stepper_; }

    LoopState state() const;
    void resume(const LoopState& state);

  private:
    struct FrameUnderWay {
        ContactSteps steps;
        uint32_t remaining = 0;      ///< substeps
        bool moved = false;          ///< anything, so far
        bool split = false;          ///< preset pieces have come apart
        uint32_t list_rebuilds = 0;  ///< so far
        LoopState before;

        uint32_t at() const { return steps.substeps() - remaining; }  ///< substeps
    };

    bool staysQuiet(uint32_t n) const;
    StepStatus runFrame(const FrameWatch& watch);
    Stretch stretch() const;
    /// Of the frame under way: to the ends of as many contact steps, or as far as the next start of a
    /// projectile or the last end before the next decision.
    Stretch nextStretch() const;
    /// Substeps that no stretch exceeds.
    uint32_t longestStretch() const { return stretch().length() / kRigidStride * longestStep(); }
    uint32_t longestStep() const {
        return frame_ ? std::max(kRigidStride, frame_->steps.longest()) : kRigidStride;
    }
    uint32_t untilNextStart(uint32_t at_most) const;
    uint32_t wholeSteps(uint32_t n) const { return frame_->steps.wholeWithin(frame_->at(), n); }
    /// At most all that remain of the frame: 0 also where the decision is due within a contact step, whose
    /// end is too late for it.
    uint32_t untilDecision() const { return wholeSteps(decisions_.substepsUntilDue(frame_->remaining)); }
    /// As far as the lists reach that do not last for a stretch: no decision knows what comes later.
    uint32_t untilHorizon() const {
        return wholeSteps(lists_.lastFor(scene_.lists.horizon(), stretch().length(), frame_->remaining));
    }
    void decide(bool frame_starts, uint32_t remaining);
    void decideIfDue(uint32_t remaining);
    /// Those of preset pieces that are hit within the next stretch come apart; new lists, if some did. s
    /// until the next one is hit, if it is before the next decision. May wait.
    struct Release {
        bool splits = false;
        double next = 1e30;
    };
    Release releasePieces(double soon);
    /// Builds the contact lists if that is due.
    void freshenLists();
    void buildLists();
    /// Velocities of what paths lead, for the next `n` substeps.
    void leadHeld(uint32_t n);
    void look(uint32_t lookahead);
    void followStrayed(uint32_t next);
    void runAwake(uint32_t n);
    bool movesBonds() const { return !scene_.regimes.on() || scene_.regimes.movesBonds(); }
    bool movesRigid() const { return scene_.regimes.on() && scene_.regimes.movesRigid(); }
    bool nothingMoves() const {
        const auto& regimes = scene_.regimes;
        return regimes.on() && !regimes.movesBonds() && !regimes.movesRigid();
    }

    Scene& scene_;
    Projectiles& projectiles_;
    ListSchedule lists_;
    Decisions<Backend, Real> decisions_;
    Stepper<Backend, Real> stepper_;
    StateLook<Backend, Real> look_;
    StrayPaths<Backend, Real> strays_;
    Checkpoint<Backend, Real> frame_start_, present_;
    std::optional<FrameUnderWay> frame_;
    bool quiet_ = false;
};

template <class Backend, class Real>
typename FrameLoop<Backend, Real>::Frame FrameLoop<Backend, Real>::advance(uint32_t n,
                                                                           const FrameWatch& watch) {
    if (!frame_) {
        if (staysQuiet(n)) {
            scene_.substeps += n;
            decisions_.noteFrame(n);
            return {StepStatus::kOk, true, n, 0};
        }
        beginFrame(n);
    }
    const StepStatus status = runFrame(watch);
    if (status != StepStatus::kOk) {
        giveUpFrame();
        return {status, false, 0, 0};
    }
    if (frame_->remaining > 0) return {};
    const FrameUnderWay frame = *std::exchange(frame_, std::nullopt);
    decisions_.noteFrame(frame.steps.substeps());
    return {status, false, frame.steps.substeps(), frame.list_rebuilds};
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::beginFrame(uint32_t n) {
    frame_ = FrameUnderWay{ContactSteps(n), n, false, false, 0, state()};
    if (frame_->steps.longest() > ContactSteps(decisions_.lastFrame()).longest())
        lists_.demand();  // they were made for shorter stretches
    stepper_.listsChange();
    frame_start_.keep(scene_);
    startProjectiles();
    leadHeld(std::min(n, kRigidStretch.length()));  // what the last decision counted is in no snapshot
    if (!scene_.regimes.on()) return scene_.startBonded(n * scene_.tables.time_step);
    freshenLists();
    decide(true, n);
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::giveUpFrame() {
    if (!frame_) return;
    frame_start_.putBack(scene_);
    stepper_.takePlacing();
    const FrameUnderWay given_up = *std::exchange(frame_, std::nullopt);
    resume(given_up.before);
    if (given_up.split) scene_.fragments.follow(scene_.data);
}

/// Everything sleeps, no projectile starts and no path leads anywhere: the frame would change nothing but the
/// time.
template <class Backend, class Real>
bool FrameLoop<Backend, Real>::staysQuiet(uint32_t n) const {
    return quiet_ && !lists_.due() && !decisions_.shotStarted() &&
           projectiles_.nextStart() >= scene_.substeps + n &&
           !scene_.held.leads(scene_.time(), scene_.time() + n * scene_.tables.time_step);
}

/// Until the stretch after the end of a path: there it stops.
template <class Backend, class Real>
void FrameLoop<Backend, Real>::leadHeld(uint32_t n) {
    const double now = scene_.time(), dt = scene_.tables.time_step;
    if (!scene_.held.leads(now - kRigidStretch.length() * dt, now + n * dt)) return;
    stepper_.placeRigid(scene_);
    stepper_.listsChange();
    scene_.held.lead(scene_.data, now, n * dt);
    if (scene_.regimes.on()) scene_.regimes.leadBodies(scene_.data, scene_.fragments.clusters);
}

/// To the end of the frame, or as far as `watch` wants.
template <class Backend, class Real>
StepStatus FrameLoop<Backend, Real>::runFrame(const FrameWatch& watch) {
    uint32_t& n = frame_->remaining;
    while (n > 0) {
        startProjectiles();
        decideIfDue(n);
        if (nothingMoves()) {
            const uint32_t quiet = untilNextStart(n);
            scene_.substeps += quiet;
            n -= quiet;
            continue;
        }
        frame_->moved = true;
        const Stretch part = nextStretch();
        leadHeld(part.length());
        const StepStatus status = runStretch(part);
        if (status != StepStatus::kOk) return status;
        n -= part.length();
        if (watch && n > 0 && !watch(1 - static_cast<double>(n) / frame_->steps.substeps())) return status;
    }
    quiet_ = !frame_->moved;
    if (quiet_) return StepStatus::kOk;
    look(0);
    return look_.wait().status;
}

/// The look in it decides for its end, and has to see as far as the end of the next.
template <class Backend, class Real>
StepStatus FrameLoop<Backend, Real>::runStretch(const Stretch& part) {
    freshenLists();
    const uint32_t next = longestStretch();
    runAwake(part.first);
    look(part.second + next);
    runAwake(part.second);
    const auto answer = look_.wait();
    const bool is_good = answer.status == StepStatus::kOk;
    if (lists_.judge(answer.left_paths, is_good, next, scene_.lists.horizon())) followStrayed(next);
    return answer.status;
}

/// Without bonds nothing happens fast but hits by projectiles, which cut it short.
template <class Backend, class Real>
Stretch FrameLoop<Backend, Real>::stretch() const {
    if (!movesBonds()) return kRigidStretch;
    return scene_.tables.time_step < kShortSubstep ? kShortBondedStretch : kBondedStretch;
}

template <class Backend, class Real>
Stretch FrameLoop<Backend, Real>::nextStretch() const {
    const Stretch nominal = stretch();
    const auto until = [&](uint32_t substeps) {
        return frame_->steps.untilEnd(substeps / kRigidStride, frame_->at());
    };
    // What is due within the contact step right after a decision has been decided by it.
    const uint32_t decided = std::max(std::min(untilDecision(), untilHorizon()), until(kRigidStride)),
                   length = untilNextStart(std::min(until(nominal.length()), decided)),
                   first = std::min(length, until(nominal.first));
    return {first, length - first};
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::runAwake(uint32_t n) {
    if (n == 0) return;  // no step: the length of the last one stays what it was
    stepper_.run(scene_, n);
    lists_.pass(n);
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::decideIfDue(uint32_t remaining) {
    const bool new_lists = lists_.due(), is_due = untilDecision() == 0;
    if (new_lists) buildLists();
    if (is_due ||
        (new_lists && decisions_.isNeededByNewLists(lists_.remaining(scene_.lists.horizon(), remaining))))
        decide(false, remaining);
}

/// remaining: substeps of the frame that are still to come. The next decision comes with the next contact
/// lists, or when the frame is over, at the latest.
template <class Backend, class Real>
void FrameLoop<Backend, Real>::decide(bool frame_starts, uint32_t remaining) {
    stepper_.placeRigid(scene_);
    stepper_.listsChange();
    const Release release = releasePieces(lists_.remaining(scene_.lists.horizon(), remaining));
    if (frame_starts || release.splits) scene_.markHolds(remaining * scene_.tables.time_step);
    decisions_.decide(frame_starts || release.splits, frame_starts ? decisions_.lastFrame() : 0,
                      lists_.remaining(scene_.lists.horizon(), remaining), stepper_.contactStride(),
                      frame_->steps.lengthAt(frame_->at()));
    decisions_.hasten(release.next, kRigidStretch.length());
}

template <class Backend, class Real>
typename FrameLoop<Backend, Real>::Release FrameLoop<Backend, Real>::releasePieces(double soon) {
    auto& release = scene_.release;
    if (!release.on()) return {};
    const HardTouches<Real> touches = scene_.hardTouches(soon);
    const auto foreseen = release.foresee(touches, kRigidStretch.length() * scene_.tables.time_step);
    if (foreseen.splits) {
        auto& data = scene_.data;
        release.release(touches, data.bonds.row_start.view(), data.bonds.link.span());
        scene_.regimes.splitRigid(scene_.fragments.clusters, data.particles.owner.view(), release.splits());
        scene_.fragments.follow(data);
        buildLists();
        frame_->split = true;
    }
    return {foreseen.splits, foreseen.next};
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::freshenLists() {
    if (lists_.due()) buildLists();
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::buildLists() {
    stepper_.placeRigid(scene_);
    stepper_.listsChange();
    scene_.lists.use(lists_.next(decisions_.somethingRigid(), decisions_.shotStarted(), longestStep()));
    scene_.lists.build(scene_.state(), scene_.data.particles.constants.view(), scene_.data.bonds.in());
    lists_.built();
    if (frame_) ++frame_->list_rebuilds;
}

template <class Backend, class Real>
template <class Use>
void FrameLoop<Backend, Real>::withGoodLists(const Use& use) {
    if (!lists_.due()) return use();
    stepper_.placeRigid(scene_);
    present_.keep(scene_);
    const ListSchedule::State schedule = lists_.state();
    buildLists();
    use();
    present_.putBack(scene_);
    lists_.resume(schedule);
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::look(uint32_t lookahead) {
    look_.start(scene_, stepper_, lists_.age(), lookahead * scene_.tables.time_step);
}

/// At the end of a stretch, with lists that hold for another: `next` substeps. Waits.
template <class Backend, class Real>
void FrameLoop<Backend, Real>::followStrayed(uint32_t next) {
    stepper_.placeRigid(scene_);
    stepper_.listsChange();
    const auto answer = strays_.restart(scene_, lists_.age(), next * scene_.tables.time_step);
    if (answer.lists_hold)
        decisions_.hasten(answer.decide_within, next);
    else
        lists_.demand();
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::startProjectiles() {
    for (const uint32_t slot : projectiles_.due(scene_.substeps)) {
        stepper_.placeRigid(scene_);
        const Projectile shot = scene_.setBack(projectiles_.all()[slot]);
        scene_.place(slot, shot);
        projectiles_.start(slot, shot);
        lists_.demand();
        decisions_.noteShot();
    }
}

/// at_most, or less: up to the next start of a waiting projectile. Those that are due have started.
template <class Backend, class Real>
uint32_t FrameLoop<Backend, Real>::untilNextStart(uint32_t at_most) const {
    return static_cast<uint32_t>(std::min<uint64_t>(at_most, projectiles_.nextStart() - scene_.substeps));
}

template <class Backend, class Real>
LoopState FrameLoop<Backend, Real>::state() const {
    return {scene_.substeps,      quiet_ ? uint64_t{1} : 0, stepper_.contactStride(),
            projectiles_.state(), lists_.state(),           decisions_.state()};
}

template <class Backend, class Real>
void FrameLoop<Backend, Real>::resume(const LoopState& state) {
    scene_.substeps = state.substeps;
    quiet_ = state.quiet != 0;
    stepper_.resume(static_cast<uint32_t>(state.contact_stride));
    projectiles_.resume(state.projectiles);
    lists_.resume(state.lists);
    decisions_.resume(state.decisions);
}

}  // namespace demolish
