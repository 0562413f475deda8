// Runs substeps on the GPU: kSubstepsTogether of them as one CUDA graph, single launches for what is left
// over.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdlib>

#include "sim_cuda/kernels/substep_cuda.cuh"
#include "sim_cuda/solver/cuda_substep_key.cuh"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/substep_runner.h"

namespace demolish {

/// Threads a particle: measured on an H200 from 2k to 200k. DEMOLISH_THREADS_PER_PARTICLE
/// overrides it, for measurements; every choice gives the same bits.
inline uint32_t threadsPerParticle(uint32_t particles) {
    if (const char* wish = std::getenv("DEMOLISH_THREADS_PER_PARTICLE")) {
        const auto threads = static_cast<uint32_t>(std::atoi(wish));
        if (std::has_single_bit(threads) && threads <= 16) return threads;
    }
    if (particles < 4'000) return 16;
    return particles < 16'000 ? 8 : 4;
}

template <class Real>
class SubstepRunner<CudaBackend, Real> {
  public:
    explicit SubstepRunner(CudaBackend&) {}
    /// n substeps from data.current on, which turns with each of them. Does not wait.
    void run(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
             ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
             uint32_t n) {
        if (backend.isIdle())
            n -= runSingly(backend, data, contacts, params, ledger, std::min(n, kSubstepsTogether));
        for (; n >= kSubstepsTogether; n -= kSubstepsTogether)
            runInterval(backend, data, contacts, params, ledger);
        runSingly(backend, data, contacts, params, ledger, n);
    }
    /// `follows`: right after another step of the same work lists, whose end it need not wait for to start.
    void runOne(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
                ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
                bool follows = false) {
        const SubstepArrays<Real> arrays = data.arraysInSubsteps(contacts);
        const Launch launch{backend.stream(), follows};
        ledger ? launchWith<true>(launch, arrays, params) : launchWith<false>(launch, arrays, params);
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

  private:
    /// As single launches, which start sooner than a graph does. Returns n.
    uint32_t runSingly(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
                       ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params,
                       bool ledger, uint32_t n) {
        for (uint32_t k = 0; k < n; ++k) runOne(backend, data, contacts, params, ledger, k > 0);
        return n;
    }
    struct Launch {
        cudaStream_t stream = nullptr;
        bool follows = false;
    };
    static GraphKey keyOf(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, bool ledger) {
        GraphKey key = stepKey(arrays, params, ledger);
        key.insert(key.end(),
                   {keyWord(double(params.velocity_keep)), params.breaking, keyWord(double(params.dt)),
                    keyWord(arrays.work.ids), keyWord(arrays.work.regime),
                    launchedParticles(arrays.work, params), threadsFor(arrays.work, params)});
        return key;
    }

    /// Particles that threads are started for.
    static uint32_t launchedParticles(const BondedWork& work, const StepParams<Real>& params) {
        return work.all() ? params.in_bodies : std::min(params.in_bodies, roundedUp(work.at_most));
    }

    static uint32_t threadsFor(const BondedWork& work, const StepParams<Real>& params) {
        return threadsPerParticle(work.all() ? params.in_bodies : work.at_most);
    }

    void runInterval(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
                     ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params,
                     bool ledger) {
        static_assert(kSubstepsTogether % 2 == 0, "a graph must end on the state it started from");
        graphs_.run(backend, keyOf(data, contacts, params, ledger), [&] {
            for (uint32_t k = 0; k < kSubstepsTogether; ++k)
                runOne(backend, data, contacts, params, ledger, k > 0);
        });
    }

    template <bool kLedger>
    static void launchWith(const Launch& launch, const SubstepArrays<Real>& arrays,
                           const StepParams<Real>& params) {
        switch (threadsFor(arrays.work, params)) {
            case 1:
                return launchT<1, kLedger>(launch, arrays, params);
            case 2:
                return launchT<2, kLedger>(launch, arrays, params);
            case 4:
                return launchT<4, kLedger>(launch, arrays, params);
            case 8:
                return launchT<8, kLedger>(launch, arrays, params);
            default:
                return launchT<16, kLedger>(launch, arrays, params);
        }
    }

    template <uint32_t T, bool kLedger>
    static void launchT(const Launch& launch, const SubstepArrays<Real>& arrays,
                        const StepParams<Real>& params) {
        constexpr uint32_t kParticles = kSubstepBlock / T;
        const uint32_t particles = launchedParticles(arrays.work, params);
        const uint32_t blocks = (particles + kParticles - 1) / kParticles + kMaxProjectiles;
        launchChained(launch.stream, launch.follows, substepKernel<T, kLedger, Real>, blocks, kSubstepBlock,
                      "starting a substep", arrays, params);
    }

    CudaGraphCache graphs_;
};

}  // namespace demolish
