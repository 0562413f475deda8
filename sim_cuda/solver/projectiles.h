// SPDX-License-Identifier: Apache-2.0
// The projectiles of a run on the host: which slot each has, when it starts, where it is drawn until then.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/params.h"

namespace demolish {

/// kg
double projectileMass(const Projectile& projectile);

/// Owns the list of projectiles, in the order of their slots, and which of them have started. Substeps are
/// counted from the start of the run.
class Projectiles {
  public:
    /// What changes while stepping.
    struct State {
        double work = 0;       ///< J that have come in with projectiles after the beginning
        uint64_t started = 0;  ///< a bit a slot
        uint64_t begun = 0;    ///< 1: whoever starts now has not been there at the beginning
    };

    /// gravity: m/s^2; time_step: s, of a substep.
    Projectiles(std::vector<Projectile> waiting, const Double3& gravity, double time_step);

    /// One more, which starts at this substep. Throws UsageError on values out of range and beyond
    /// kMaxProjectiles.
    void fire(const Projectile& projectile, uint64_t substep);

    /// First substep at which the next waiting one takes part; the largest number when none waits.
    uint64_t nextStart() const;
    /// Slots of those that wait and whose time has come by this substep, ascending.
    std::vector<uint32_t> due(uint64_t substep) const;
    /// The one of `slot` takes part from now on, as it was placed.
    void start(uint32_t slot, const Projectile& placed);
    /// The run begins: what starts later puts in work.
    void begin() { state_.begun = 1; }

    /// m, centre of a projectile that still waits at this time (s): on its way to where it starts.
    Double3 waitingAt(uint32_t slot, double time) const;

    const std::vector<Projectile>& all() const { return all_; }
    /// J: energy that comes in after the beginning is external work.
    double work() const { return state_.work; }

    const State& state() const { return state_; }
    void resume(const State& state) { state_ = state; }
    void resume(std::vector<Projectile> all, const State& state);

  private:
    bool hasStarted(size_t slot) const { return (state_.started >> slot & 1u) != 0; }
    uint64_t startSubstep(const Projectile& projectile) const;
    double energyOf(const Projectile& projectile) const;

    std::vector<Projectile> all_;
    Double3 gravity_;
    double time_step_;
    State state_;
};

}  // namespace demolish
