// SPDX-License-Identifier: Apache-2.0
// When contact lists are made anew, and how long the next ones shall last.
#pragma once
#include <cstdint>

#include "sim_cuda/solver/neighbour_settings.h"

namespace demolish {

/// Knows how old the lists are and how long they have lasted of late; it owns no lists.
class ListSchedule {
  public:
    /// What changes while stepping.
    struct State {
        uint32_t age = 0;        ///< substeps since the build
        uint32_t life = 10'000;  ///< substeps that lists have lasted of late
        uint32_t due = 1;        ///< 1: they must be built before the next substep
    };

    /// time_step: s, of a substep.
    explicit ListSchedule(double time_step) : time_step_(time_step) {}

    bool due() const { return state_.due != 0; }
    void demand() { state_.due = 1; }
    void pass(uint32_t substeps) { state_.age += substeps; }

    /// For the build that is due. A projectile's start says nothing about how long lists last. longest_step:
    /// substeps of a contact step, at most.
    NeighbourSettings next(bool something_is_rigid, bool projectile_started, uint32_t longest_step);
    void built();

    /// What a look has found, with `next` substeps to come before the answer of the next one. True: lists
    /// that hold as long could be kept if those who have left their paths got new ones. horizon: s after the
    /// build.
    bool judge(bool left_paths, bool state_is_good, uint32_t next, double horizon);

    double age() const { return state_.age * time_step_; }  ///< s since the build
    /// s for which the lists still hold, at most so many substeps.
    double remaining(double horizon, uint32_t at_most) const;
    /// at_most; fewer where even new lists do not last for `stretch` substeps: those for which they still do.
    uint32_t lastFor(double horizon, uint32_t stretch, uint32_t at_most) const;

    const State& state() const { return state_; }
    void resume(const State& state) { state_ = state; }

  private:
    double time_step_;
    State state_;
};

}  // namespace demolish
