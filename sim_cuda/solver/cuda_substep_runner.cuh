// SPDX-License-Identifier: Apache-2.0
// Runs substeps on the GPU: kSubstepsTogether of them as one CUDA graph, single launches for what is left
// over and where lists are new.
#pragma once
#include <algorithm>

#include "sim_cuda/kernels/substep_cuda.cuh"
#include "sim_cuda/solver/cuda_substep_key.cuh"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/substep_runner.h"
#include "sim_cuda/solver/substep_width.h"

namespace demolish {

template <class Real>
class SubstepRunner<CudaBackend, Real> {
  public:
    explicit SubstepRunner(CudaBackend&) {}
    /// n substeps from data.current on, which turns with each of them. `follows` as for runOne(). Does not
    /// wait.
    void run(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
             ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
             uint32_t n, bool follows = false) {
        const auto steps = [&](uint32_t substeps) {
            for (uint32_t k = 0; k < substeps; ++k)
                runOne(backend, data, contacts, params, ledger, follows || k > 0);
        };
        for (; n >= kSubstepsTogether; n -= kSubstepsTogether) {
            static_assert(kSubstepsTogether % 2 == 0, "a graph must end on the state it started from");
            graphs_.run(backend, keyOf(data, contacts, params, ledger), [&] { steps(kSubstepsTogether); });
        }
        steps(n);
    }
    /// `follows`: right after another step of the same work lists, whose end it need not wait for to start.
    void runOne(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
                ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
                bool follows = false) {
        const SubstepArrays<Real> arrays = data.arraysInSubsteps(contacts);
        launchOne(backend, follows, widthFor(arrays.work, params), arrays, params, ledger);
        data.current = 1 - data.current;
    }
    /// n more right after one. Does not wait.
    void runOn(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
               ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
               uint32_t n) {
        for (; n > 0; --n) runOne(backend, data, contacts, params, ledger, true);
    }
    /// What the launches of a substep depend on.
    static GraphKey keyOf(SolverData<CudaBackend, Real>& data, ContactArrays<CudaBackend, Real>& contacts,
                          const StepParams<Real>& params, bool ledger) {
        return keyOf(data.arraysInSubsteps(contacts), params, ledger);
    }

    /// The graphs that so many particles may need, so that none is recorded while things break.
    void recordAhead(CudaBackend& backend, uint32_t particles, bool ledger) {
        forEachWidth(particles, [&](const SubstepWidth& width) {
            graphs_.recordAhead(backend, [&] {
                for (uint32_t k = 0; k < kSubstepsTogether; ++k)
                    launchOne(backend, k > 0, width, {}, {}, ledger);
            });
        });
    }
    static void launchOne(CudaBackend& backend, bool follows, const SubstepWidth& width,
                          const SubstepArrays<Real>& arrays, const StepParams<Real>& params, bool ledger) {
        const Launch launch{backend, follows};
        if (ledger)
            launchWith<true, false>(launch, width, arrays, params);
        else if (params.colliders.arePlanes())
            launchWith<false, true>(launch, width, arrays, params);
        else
            launchWith<false, false>(launch, width, arrays, params);
    }

  private:
    struct Launch {
        CudaBackend& backend;
        bool follows = false;
    };
    static GraphKey keyOf(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, bool ledger) {
        GraphKey key = stepKey(arrays, params, ledger);
        key.insert(key.end(),
                   {keyWord(double(params.velocity_keep)), params.breaking, params.leaves_out,
                    keyWord(double(params.dt)), keyWord(arrays.work.ids), keyWord(arrays.work.regime),
                    launchedParticles(arrays.work, params), widthFor(arrays.work, params).threads,
                    widthFor(arrays.work, params).moves_apart});
        return key;
    }

    /// Particles that threads are started for.
    static uint32_t launchedParticles(const BondedWork& work, const StepParams<Real>& params) {
        return work.all() ? params.in_bodies : std::min(params.in_bodies, roundedUp(work.at_most));
    }

    static SubstepWidth widthFor(const BondedWork& work, const StepParams<Real>& params) {
        return substepWidth(work.all() ? params.in_bodies : work.at_most);
    }

    template <bool kLedger, bool kOnlyPlanes>
    static void launchWith(const Launch& launch, const SubstepWidth& width, const SubstepArrays<Real>& arrays,
                           const StepParams<Real>& params) {
        if (width.threads >= 16)
            launchT<16, true, kLedger, kOnlyPlanes>(launch, arrays, params);
        else if (width.threads >= 8)
            launchT<8, true, kLedger, kOnlyPlanes>(launch, arrays, params);
        else if (width.moves_apart)
            launchT<4, true, kLedger, kOnlyPlanes>(launch, arrays, params);
        else
            launchT<4, false, kLedger, kOnlyPlanes>(launch, arrays, params);
    }

    template <uint32_t T, bool kMovesApart, bool kLedger, bool kOnlyPlanes>
    static void launchT(const Launch& launch, const SubstepArrays<Real>& arrays,
                        const StepParams<Real>& params) {
        launch.backend.launch(launch.follows, substepKernel<T, kMovesApart, kLedger, kOnlyPlanes, Real>,
                              blocksFor(arrays.work, params, T), substepThreads(kMovesApart),
                              "starting a substep", arrays, params);
    }
    static uint32_t blocksFor(const BondedWork& work, const StepParams<Real>& params, uint32_t threads) {
        const uint32_t particles = kSubstepBlock / threads;
        return (launchedParticles(work, params) + particles - 1) / particles + kMaxProjectiles;
    }

    CudaGraphCache graphs_;
};

}  // namespace demolish
