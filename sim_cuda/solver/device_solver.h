// SPDX-License-Identifier: Apache-2.0
// The solver on one backend. What a frame does, in order:
//
//   set the state aside -> how each fragment is moved
//   -> [ substeps of bonds, contact steps of rigid fragments -> look at the state -> the same once more
//        -> contact lists again, if the look said so; then again how each fragment is moved ] ...
//   -> last look -> sums of the frame -> fragments
//
// A look and the decision that follows it stand at fixed substeps, so that every device takes the same one;
// the substeps between them hide the way of the answer from the GPU. If a look saw something bad, the state
// set aside is put back.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/solver/checkpoint.h"
#include "sim_cuda/solver/clustering.h"
#include "sim_cuda/solver/fracture_surface.h"
#include "sim_cuda/solver/fragment_motion.h"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/regimes.h"
#include "sim_cuda/solver/rigid_runner.h"
#include "sim_cuda/solver/substep_runner.h"

namespace demolish {

template <class Backend, class Real>
class DeviceSolver final : public Solver {
  public:
    DeviceSolver(const SceneSetup& setup, const ProgressCallback& progress);

    StepStatus advanceFrame(double time_scale) override;
    StepStatus advanceSubsteps(uint32_t n) override;
    void fire(const Projectile& projectile) override;
    void exportFrame(const RenderStreams& streams, bool streams_fresh) override;
    const FrameStats& stats() const override { return stats_; }
    void measure() override;
    void bookEnergy(bool on) override;
    bool booksEnergy() const override { return setup_.params.ledger; }
    uint64_t stateHash() const override;
    Snapshot save() const override;
    void restore(const Snapshot& snapshot) override;
    const SofteningReport& softening() const override { return tables_.body[0].report; }
    std::string deviceName() const override { return backend_.deviceName(); }
    bool onGpu() const override { return Backend::kOnGpu; }
    void synchronize() override { backend_.synchronize(); }
    void* workStream() const override { return backend_.stream(); }

  private:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    // stepping
    StepStatus advance(uint32_t n);
    bool staysQuiet(uint32_t n) const;
    StepStatus passQuietly(uint32_t n);
    StepStatus runSubsteps(uint32_t n);
    StepStatus runChunk(uint32_t n);
    void runAwake(uint32_t n);
    void runBoth(const RigidStepOf<Backend, Real>& step, uint32_t n, bool follows);
    void runApart(const RigidStepOf<Backend, Real>& step, uint32_t n, bool follows);
    bool nothingMoves() const { return regimes_.on() && !regimes_.movesBonds() && !regimes_.movesRigid(); }
    Stretch stretch() const;
    void placeRigid();
    void look(uint32_t lookahead);
    void followStrayed(uint32_t next);
    void buildLists();
    bool mustReassign(uint32_t remaining);
    void assignRegimes(bool frame_starts, uint32_t remaining);
    uint32_t untilDecision(uint32_t at_most) const;
    double untilNextDecision(uint32_t remaining) const;
    void bookSoftening();
    void countAwake();
    void settle(double seconds, const ProgressCallback& progress);
    void recordAhead();
    void setVelocities(bool at_rest);

    // projectiles
    uint64_t nextStart() const;
    uint32_t substepsUntilNextStart(uint32_t at_most) const;
    void startProjectiles();
    void placeProjectile(uint32_t slot);
    void showProjectiles();

    // sums of a frame, snapshots
    void collectFrame(uint32_t substeps);
    void tellFrame(uint32_t substeps);
    void sumFragments();
    void countFragments();
    void updateSurface();
    void restoreSurface(uint32_t broken, const std::vector<std::byte>& state);
    Span<const uint8_t> brokenBonds();
    void writeBuffers(ByteStream& out) const;
    void readBuffers(ByteStream& in);

    static constexpr uint32_t kNothingWritten = 0xffffffffu;

    /// What changes while stepping and lives on the host.
    struct Progress {
        uint64_t substeps = 0, frames = 0;
        uint32_t since_build = 0;               ///< substeps since the contact lists were built
        uint32_t lists_last = 10'000;           ///< substeps that lists have lasted of late
        uint32_t left_paths = 0;                ///< 1: somebody had left his path when they were last made
        uint32_t rebuild = 1;                   ///< 1: they must be built before the next substep
        uint32_t last_frame = 0;                ///< substeps in the last frame
        uint64_t last_assigned = ~uint64_t{0};  ///< substep at which regimes were last decided
        uint64_t decide_at = ~uint64_t{0};      ///< substep at which they have to be decided again
        uint32_t shot_started = 0;              ///< 1: a projectile has started since then
        RegimeMemory regimes;
        uint32_t quiet = 0;        ///< 1: nothing has moved in the last frame, nor will unless it is shot at
        uint32_t moves_rigid = 0;  ///< 1: something is moved as a rigid body since the last decision
        uint32_t projectiles = 0;  ///< known so far
        uint32_t started = 0;      ///< bits of projectile slots
        uint32_t broken = 0;       ///< bonds
        uint32_t parted = 0;       ///< of these, with a retired record
        EnergyLedger energy;
    };

    SceneSetup setup_;
    SceneTables tables_;
    mutable Backend backend_;
    mutable SolverData<Backend, Real> data_;
    mutable NeighbourLists<Backend, Real> lists_;
    SubstepRunner<Backend, Real> runner_;
    RigidRunner<Backend, Real> rigid_runner_;
    mutable Regimes<Backend, Real> regimes_;
    Clustering<Backend> clusters_;
    mutable FragmentMotion<Backend, Real> motion_;
    mutable FractureSurface<Backend> surface_;
    uint32_t surface_of_ = 0;                ///< broken bonds that the surface has been told of
    uint32_t written_of_ = kNothingWritten;  ///< broken bonds when the draw lists were last written
    Checkpoint<Backend, Real> frame_start_, dry_run_;
    typename Backend::Reader reader_;
    Buffer<uint32_t> look_words_, stray_words_, strayed_;
    Buffer<uint64_t> lacking_;  ///< entries of contact rows, as the strayed find them
    mutable Buffer<uint64_t> hash_sum_;
    Buffer<Vec4<Real>> shown_projectiles_;
    std::vector<Vec4<Real>> shown_;  ///< what it holds
    Buffer<uint8_t> broken_bonds_;
    StepParams<Real> params_;
    std::vector<Projectile> projectiles_;  ///< in their slots
    Progress progress_;
    bool lists_stand_ =
        false;  ///< since the last step nothing that steps read has been written but the state
    bool recorded_ahead_[2] = {};  ///< GPU: sequences of steps, without and with the ledger
    bool place_rigid_ = false;     ///< contact steps have moved bodies whose particles have not followed yet
    FrameStats stats_;
};

}  // namespace demolish

#include "sim_cuda/solver/device_solver_awake.h"
#include "sim_cuda/solver/device_solver_export.h"
#include "sim_cuda/solver/device_solver_projectiles.h"
#include "sim_cuda/solver/device_solver_state.h"
#include "sim_cuda/solver/device_solver_step.h"
#include "sim_cuda/solver/device_solver_strays.h"
