// SPDX-License-Identifier: Apache-2.0
// Contact steps of rigid fragments on the GPU: two or three kernels each, with substeps between them where
// these carry some of the particles.
#pragma once
#include "sim_cuda/kernels/rigid_load_cuda.cuh"
#include "sim_cuda/kernels/rigid_step_cuda.cuh"
#include "sim_cuda/solver/cuda_substep_key.cuh"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/rigid_runner.h"
#include "sim_cuda/solver/substep_width.h"

namespace demolish {

template <class Real>
class RigidRunner<CudaBackend, Real> {
  public:
    using Step = RigidStepOf<CudaBackend, Real>;

    /// As on the CPU; does not wait. `follows`: nothing that steps read but the state has been written since
    /// the step before.
    void run(CudaBackend& backend, const Step& step, const ContactSteps& steps, bool follows) {
        makeRoom(backend, step.work);
        GraphKey key = keyOf(step);
        key.insert(key.end(), {steps.substeps(), step.before});
        graphs_.run(backend, key, [&] {
            uint32_t previous = step.before;
            for (uint32_t k = 0; k < steps.count(); ++k) {
                const uint32_t stride = steps.length(k);
                gather(backend, step, previous, stride, follows || k > 0);
                move(backend, step, previous, stride, false);
                previous = stride;
            }
        });
    }
    /// As on the CPU, with substeps of `runner`. A graph must end on the state it started from: steps of an
    /// odd number of substeps are none.
    template <class Runner, class Take>
    void runCarrying(CudaBackend& backend, const Step& step, const Runner& runner, const ContactSteps& steps,
                     const Take& take) {
        makeRoom(backend, step.work);
        for (uint32_t k = 0; k < steps.count(); ++k) {
            const uint32_t stride = steps.length(k);
            if (stride % 2 == 0)
                graphs_.run(backend, carryingKey(step, runner, stride), [&] { take(stride, k > 0); });
            else
                take(stride, k > 0);
        }
    }
    void gather(CudaBackend& backend, const Step& step, uint32_t previous, uint32_t stride, bool follows) {
        launchGather(backend, follows, gatherOf(step, previous, stride), roundedUp(step.work.active_at_most),
                     step.ledger);
    }
    void moveCarrying(CudaBackend& backend, const Step& step, uint32_t stride) {
        move(backend, step, stride, stride, true);
    }
    /// As on the CPU; does not wait.
    Span<const RigidLoadsOf<Real>> loadsNow(CudaBackend& backend, const Step& step) {
        makeRoom(backend, step.work);
        gather(backend, step, step.before, step.before, false);
        return load_.view();
    }

    /// The graphs that so many particles may need, so that none is recorded while things break. Runner: that
    /// of the substeps.
    template <class Runner>
    void recordAhead(CudaBackend& backend, uint32_t particles, bool ledger) {
        const auto move_nothing = [&] {
            ledger ? launchMove(backend, StepRigid<true, Real>{})
                   : launchMove(backend, StepRigid<false, Real>{});
        };
        for (uint32_t active : {kFewActive, kFewActive + 1})
            for (uint32_t substeps : {kRigidStretch.first, kShortBondedStretch.first, kRigidStretch.second})
                if (active == kFewActive || active < 2 * particles)
                    graphs_.recordAhead(backend, [&] {
                        for (uint32_t done = 0; done < substeps; done += kRigidStride) {
                            launchGather(backend, done > 0, {}, active, ledger);
                            move_nothing();
                        }
                    });
        forEachWidth(particles, [&](const SubstepWidth& width) {
            for (uint32_t active : {kFewActive, kFewActive + 1})
                if (active == kFewActive || active < 2 * particles)
                    graphs_.recordAhead(backend, [&] {
                        launchGather(backend, false, {}, active, ledger);
                        for (uint32_t k = 0; k < kRigidStride; ++k)
                            Runner::launchOne(backend, true, width, {}, {}, ledger);
                        move_nothing();
                    });
        });
    }

    /// What the launches of a step depend on.
    GraphKey keyOf(const Step& step) const {
        GraphKey key = stepKey(step.arrays(), step.params, step.ledger);
        key.insert(key.end(),
                   {keyWord(load_.view()), roundedUp(step.work.active_at_most),
                    roundedUp(step.work.fragments_at_most), roundedUp(step.work.large_at_most, kLeastLarge)});
        return key;
    }

  private:
    static constexpr uint32_t kLeastLarge = 16;

    /// The state that an odd step has turned is part of it.
    template <class Runner>
    GraphKey carryingKey(const Step& step, const Runner& runner, uint32_t stride) const {
        GraphKey key = keyOf(step);
        const GraphKey substep = runner.keyOf(step.data, step.contacts, step.params, step.ledger);
        key.insert(key.end(), substep.begin(), substep.end());
        key.push_back(stride);
        return key;
    }

    void makeRoom(CudaBackend& backend, const RigidWork& work) {
        const size_t needed = work.active_at_most;
        if (load_.size() >= needed) return;
        backend.synchronize();  // what was started before may still use it
        load_ = backend.allocate<RigidLoadsOf<Real>>(needed + needed / 2);
    }

    /// Always after another kernel of the step.
    void move(CudaBackend& backend, const Step& step, uint32_t previous, uint32_t stride, bool carried) {
        step.ledger
            ? launchMove(backend, step.template mover<true>(load_.view(), previous, stride, carried))
            : launchMove(backend, step.template mover<false>(load_.view(), previous, stride, carried));
    }
    static void launchGather(CudaBackend& backend, bool follows, const RigidGather<Real>& gather,
                             uint32_t active, bool ledger) {
        if (ledger)
            launchGatherWith<true, false>(backend, follows, gather, active);
        else if (gather.params.colliders.arePlanes())
            launchGatherWith<false, true>(backend, follows, gather, active);
        else
            launchGatherWith<false, false>(backend, follows, gather, active);
    }
    template <bool kLedger, bool kOnlyPlanes>
    static void launchGatherWith(CudaBackend& backend, bool follows, const RigidGather<Real>& gather,
                                 uint32_t active) {
        const char* name = "gathering loads of rigid fragments";
        const uint32_t collider_blocks = gatherBlocks<kFetching>(active);
        if (active <= kFewActive) {
            backend.launch(follows, rigidLoadKernel<kLedger, kOnlyPlanes, Real>,
                           collider_blocks + gatherBlocks<kThreadsOfFew>(active), kSubstepBlock, name, gather,
                           collider_blocks);
        } else {
            backend.launch(follows, rigidRowsKernel<kLedger, Real>, gatherBlocks<kThreadsOfMany>(active),
                           kSubstepBlock, name, gather);
            backend.launch(true, rigidCollidersKernel<kLedger, kOnlyPlanes, Real>, collider_blocks,
                           kSubstepBlock, name, gather);
        }
    }
    RigidGather<Real> gatherOf(const Step& step, uint32_t previous, uint32_t stride) {
        return {step.arrays(), rigidParams(step.params, previous, stride), step.work, load_.span()};
    }
    template <bool kLedger>
    static void launchMove(CudaBackend& backend, const StepRigid<kLedger, Real>& step) {
        constexpr uint32_t kWarps = kRigidLanes / kWarp;
        const uint32_t large = roundedUp(step.work.large_at_most, kLeastLarge);
        const uint32_t small = (roundedUp(step.work.fragments_at_most) + kWarps - 1) / kWarps;
        backend.launch(true, rigidStepKernel<kLedger, Real>, large + small, kRigidLanes,
                       "moving rigid fragments", step, large);
    }

    CudaBackend::Buffer<RigidLoadsOf<Real>> load_;
    CudaGraphCache graphs_;
};

}  // namespace demolish
