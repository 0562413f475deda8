// SPDX-License-Identifier: Apache-2.0
// What a run reports: counts and energies, added up frame by frame on the host.
#pragma once
#include <cstdint>

#include "sim_cuda/api/stats.h"
#include "sim_cuda/kernels/measure_energy.h"
#include "sim_cuda/kernels/sum_frame.h"
#include "sim_cuda/kernels/write_fragments.h"

namespace demolish {

/// Owns the stats and what they are continued from. Energies of the moment (kinetic, elastic, potential) are
/// those of the last measurement.
class FrameBooks {
  public:
    /// What changes while stepping.
    struct State {
        uint64_t frames = 0;
        uint32_t broken = 0;                             ///< bonds
        uint32_t parted = 0;                             ///< of these, with a retired record
        double damping = 0, friction = 0, fracture = 0;  ///< J since the start
        double held = 0;                                 ///< J, likewise: work of what holds particles
    };

    /// time_step: s; mass: kg, of the bodies.
    FrameBooks(double time_step, double mass, uint32_t particles, uint32_t bonds);

    void setStatus(StepStatus status) { stats_.status = status; }
    /// A frame of so many substeps is over at `time` (s), well. Its sums come later, or not at all if nothing
    /// has happened in it.
    void closeFrame(uint32_t substeps, double time, uint32_t list_rebuilds);
    /// booked: the sums' energies count. external: J, put in since the start by what starts later.
    void addSums(const FrameSums& sums, bool booked, double external);
    /// external: as above, up to this moment.
    void setMechanical(const MechanicalSums& sums, double external);
    void setFragments(const FragmentSummary& summary);
    void setEffects(bool shown, bool moving) {
        stats_.effects_shown = shown;
        stats_.effects_moving = moving;
    }
    /// Of the last decision; Regimes: regimes.h.
    template <class Regimes>
    void setAwake(const Regimes& regimes);

    const FrameStats& stats() const { return stats_; }

    const State& state() const { return state_; }
    /// Goes on from a state taken at `time` (s).
    void resume(const State& state, double external, double time);

  private:
    void tell(double external);

    State state_;
    FrameStats stats_;
};

template <class Regimes>
void FrameBooks::setAwake(const Regimes& regimes) {
    stats_.bonded_particles = regimes.bondedParticles();
    stats_.awake_particles = regimes.bondedParticles() + regimes.activeParticles();
    stats_.carried_particles = regimes.carriedParticles();
    stats_.rigid_fragments = regimes.rigidFragments();
    stats_.sleeping_fragments = regimes.sleepingFragments();
    stats_.awake_bodies = regimes.awakeBodies();
}

}  // namespace demolish
