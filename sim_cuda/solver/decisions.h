// SPDX-License-Identifier: Apache-2.0
// When it is decided anew how each fragment is moved (regimes.h), and what a decision brings with it.
#pragma once
#include <algorithm>

#include "sim_cuda/kernels/book_softening.h"
#include "sim_cuda/solver/device_scene.h"
#include "sim_cuda/solver/rigid_runner.h"

namespace demolish {

/// What changes while stepping.
struct DecisionState {
    static constexpr uint64_t kNever = ~uint64_t{0};

    uint64_t last = kNever;        ///< substep of the last decision
    uint64_t due = kNever;         ///< substep at which to decide again
    uint32_t shot_started = 0;     ///< 1: a projectile has started since the last one
    uint32_t something_rigid = 0;  ///< 1: something is moved as a rigid body since the last one
    uint32_t last_frame = 0;       ///< substeps in the last frame
    RegimeMemory memory;
};

/// Knows when the last decision was and when the next is due; the regimes themselves are the scene's.
template <class Backend, class Real>
class Decisions {
  public:
    explicit Decisions(DeviceScene<Backend, Real>& scene) : scene_(scene) {}

    /// Decides for the present state, which must be complete (Stepper::placeRigid), and whose contact lists
    /// must be good. `anew`: for a frame's start, or other fragments; so many substeps have passed since the
    /// last time. soon: s until the next decision at the latest. last, next: substeps of those contact steps.
    /// Waits.
    void decide(bool anew, uint32_t passed, double soon, uint32_t last, uint32_t next);

    /// Contact lists were made anew within a frame: rigid fragments need new lists of what may touch, and
    /// what comes near a sleeper within `soon` s wakes it. May wait.
    bool isNeededByNewLists(double soon);
    /// at_most, or less: up to the next decision that is due.
    uint32_t substepsUntilDue(uint32_t at_most) const {
        return static_cast<uint32_t>(std::min<uint64_t>(at_most, state_.due - scene_.substeps));
    }
    /// Two will meet in so many seconds with whom the last decision has not reckoned; it comes at the end of
    /// a stretch of so many substeps.
    void hasten(double seconds, uint32_t stretch);

    void noteShot() { state_.shot_started = 1; }
    void noteFrame(uint32_t substeps) { state_.last_frame = substeps; }
    uint32_t lastFrame() const { return state_.last_frame; }
    bool shotStarted() const { return state_.shot_started != 0; }
    bool somethingRigid() const { return state_.something_rigid != 0; }

    DecisionState state() const;
    void resume(const DecisionState& state);

  private:
    void bookSoftening(uint32_t stride);

    DeviceScene<Backend, Real>& scene_;
    DecisionState state_;
};

template <class Backend, class Real>
void Decisions<Backend, Real>::decide(bool anew, uint32_t passed, double soon, uint32_t last, uint32_t next) {
    auto& regimes = scene_.regimes;
    regimes.assign(scene_.data, scene_.lists, scene_.fragments.clusters, scene_.fragments.motion,
                   scene_.params, anew, passed, last, soon);
    if (scene_.setup.params.ledger && regimes.movesRigid()) bookSoftening(next);
    state_.last = scene_.substeps;
    state_.due = regimes.hitsLater() ? scene_.substeps + regimes.decisionInterval() : DecisionState::kNever;
    state_.shot_started = 0;
    state_.something_rigid = regimes.movesRigid() ? 1 : 0;
}

template <class Backend, class Real>
void Decisions<Backend, Real>::bookSoftening(uint32_t stride) {
    const RigidConstants<Real> constants = scene_.regimes.rigidConstants();
    MeasureEnergy<Real> bonded{scene_.arrays(), {}, scene_.params, {}, {}, {}, {}, true};
    MeasureEnergy<Real> carried = bonded, rigid = bonded;
    carried.arrays.constants = Span<const ParticleConstants<Real>>(constants.in_substeps);
    rigid.arrays.constants = Span<const ParticleConstants<Real>>(constants.in_contact_steps);
    rigid.params = rigidParams(scene_.params, stride, stride);
    rigid.params.drift = scene_.params.drift;  // a substep has brought the overlap to what it is
    scene_.backend.forEach(scene_.tables.counts.total,
                           BookSoftening<Real>{bonded, carried, rigid, scene_.regimes.rigid(),
                                               scene_.fragments.clusters.fragment(), scene_.regimes.regime(),
                                               scene_.regimes.former(), scene_.data.ledger.span()},
                           "book softening");
}

template <class Backend, class Real>
bool Decisions<Backend, Real>::isNeededByNewLists(double soon) {
    auto& regimes = scene_.regimes;
    if (!regimes.on() || state_.last == scene_.substeps) return false;
    return shotStarted() || regimes.movesRigid() || substepsUntilDue(1) == 0 ||
           regimes.stirs(scene_.data, scene_.lists, scene_.fragments.clusters, soon);
}

template <class Backend, class Real>
void Decisions<Backend, Real>::hasten(double seconds, uint32_t stretch) {
    if (!scene_.regimes.on() || !scene_.regimes.leavesBonds() || !(seconds < 1)) return;
    const auto stretches = static_cast<uint64_t>(seconds / (stretch * scene_.tables.time_step));
    state_.due = std::min(state_.due, scene_.substeps + stretches * stretch);
}

template <class Backend, class Real>
DecisionState Decisions<Backend, Real>::state() const {
    DecisionState state = state_;
    state.memory = scene_.regimes.memory();
    return state;
}

template <class Backend, class Real>
void Decisions<Backend, Real>::resume(const DecisionState& state) {
    state_ = state;
    scene_.regimes.remember(state.memory);
}

}  // namespace demolish
