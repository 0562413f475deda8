// Contact steps of rigid fragments on the GPU: two kernels each, with substeps between them one graph.
#pragma once
#include "sim_cuda/kernels/rigid_step_cuda.cuh"
#include "sim_cuda/solver/cuda_substep_key.cuh"
#include "sim_cuda/solver/rigid_runner.h"

namespace demolish {

template <class Real>
class RigidRunner<CudaBackend, Real> {
  public:
    using Step = RigidStepOf<CudaBackend, Real>;

    /// As on the CPU; does not wait.
    void run(CudaBackend& backend, const Step& step, uint32_t n) {
        makeRoom(backend, step.work);
        const auto steps = [&](uint32_t substeps) {
            for (uint32_t done = 0; done < substeps;) {
                const uint32_t stride = std::min(kRigidStride, substeps - done);
                gather(backend, step, stride, done > 0);
                move(backend, step, stride, false);
                done += stride;
            }
        };
        n -= startSingly(backend, n, steps);
        if (n == 0) return;
        GraphKey key = keyOf(step);
        key.push_back(n);
        graphs_.run(backend, key, [&] { steps(n); });
    }
    /// steps(n), which starts n substeps of `runner` too, each whole contact step as a graph: while things
    /// break few sequences come again, and the shorter ones sooner.
    template <class Runner, class Steps>
    void repeat(CudaBackend& backend, const Step& step, const Runner& runner, uint32_t n,
                const Steps& steps) {
        static_assert(kRigidStride % 2 == 0, "a graph must end on the state it started from");
        makeRoom(backend, step.work);
        n -= startSingly(backend, n, steps);
        if (n >= kRigidStride) {
            GraphKey key = keyOf(step);
            const GraphKey substep = runner.keyOf(step.data, step.contacts, step.params, step.ledger);
            key.insert(key.end(), substep.begin(), substep.end());
            for (; n >= kRigidStride; n -= kRigidStride)
                graphs_.run(backend, key, [&] { steps(kRigidStride); });
        }
        if (n > 0) steps(n);
    }
    void gather(CudaBackend& backend, const Step& step, uint32_t stride, bool follows) {
        step.ledger ? gatherWith<true>(backend, step, stride, follows)
                    : gatherWith<false>(backend, step, stride, follows);
    }
    /// Always after another kernel of the step.
    void move(CudaBackend& backend, const Step& step, uint32_t stride, bool carried) {
        step.ledger ? moveWith<true>(backend, step, stride, carried)
                    : moveWith<false>(backend, step, stride, carried);
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
    /// Particles up to which sixteen and eight threads share the rows of one, else four.
    static constexpr uint32_t kFewActive = 8192, kManyActive = 65'536;

    static constexpr uint32_t kLeastLarge = 16;

    /// While the GPU waits, the first contact step by single launches, which start sooner than a graph does.
    /// Returns the substeps done.
    template <class Steps>
    static uint32_t startSingly(CudaBackend& backend, uint32_t n, const Steps& steps) {
        if (!backend.isIdle()) return 0;
        const uint32_t first = std::min(kRigidStride, n);
        steps(first);
        return first;
    }
    void makeRoom(CudaBackend& backend, const RigidWork& work) {
        if (load_.size() >= work.active_at_most) return;
        backend.synchronize();  // what was started before may still use it
        load_ = backend.allocate<RigidLoad<Real>>(work.active_at_most + work.active_at_most / 2);
    }

    template <bool kLedger>
    void gatherWith(CudaBackend& backend, const Step& step, uint32_t stride, bool follows) {
        const uint32_t active = roundedUp(step.work.active_at_most);
        if (active <= kFewActive)
            launchGather<16, kLedger>(backend, step, stride, active, follows);
        else if (active <= kManyActive)
            launchGather<8, kLedger>(backend, step, stride, active, follows);
        else
            launchGather<4, kLedger>(backend, step, stride, active, follows);
    }
    template <uint32_t T, bool kLedger>
    void launchGather(CudaBackend& backend, const Step& step, uint32_t stride, uint32_t active,
                      bool follows) {
        constexpr uint32_t kParticles = kSubstepBlock / T;
        launchChained(backend.stream(), follows, rigidLoadKernel<T, kLedger, Real>,
                      (active + kParticles - 1) / kParticles, kSubstepBlock,
                      "gathering loads of rigid fragments", step.arrays(), rigidParams(step.params, stride),
                      step.work, load_.span());
    }
    template <bool kLedger>
    void moveWith(CudaBackend& backend, const Step& step, uint32_t stride, bool carried) {
        constexpr uint32_t kWarps = kRigidLanes / kWarp;
        const uint32_t large = roundedUp(step.work.large_at_most, kLeastLarge);
        const uint32_t small = (roundedUp(step.work.fragments_at_most) + kWarps - 1) / kWarps;
        launchChained(backend.stream(), true, rigidStepKernel<kLedger, Real>, large + small, kRigidLanes,
                      "moving rigid fragments", step.template mover<kLedger>(load_.view(), stride, carried),
                      large);
    }

    CudaBackend::Buffer<RigidLoad<Real>> load_;
    CudaGraphCache graphs_;
};

}  // namespace demolish
