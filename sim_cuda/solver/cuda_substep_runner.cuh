// Runs substeps on the GPU: kLookInterval of them as one CUDA graph, single launches for what is left over.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <vector>

#include "sim_cuda/backend/cuda_backend.cuh"
#include "sim_cuda/kernels/substep_cuda.cuh"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/substep_runner.h"

namespace demolish {

/// Threads a particle: measured on an H200 at 2k, 10k, 50k and 200k. DEMOLISH_THREADS_PER_PARTICLE
/// overrides it, for measurements; every choice gives the same bits.
inline uint32_t threadsPerParticle(uint32_t particles) {
    if (const char* wish = std::getenv("DEMOLISH_THREADS_PER_PARTICLE")) {
        const auto threads = static_cast<uint32_t>(std::atoi(wish));
        if (std::has_single_bit(threads) && threads <= 16) return threads;
    }
    if (particles < 5'000) return 16;
    return particles < 25'000 ? 8 : 4;
}

template <class Real>
class SubstepRunner<CudaBackend, Real> {
  public:
    explicit SubstepRunner(CudaBackend&) {}
    ~SubstepRunner() {
        for (const Recorded& recorded : graphs_) cudaGraphExecDestroy(recorded.graph);
    }
    SubstepRunner(const SubstepRunner&) = delete;
    SubstepRunner& operator=(const SubstepRunner&) = delete;

    /// n substeps from data.current on, which turns with each of them. Does not wait.
    void run(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
             ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
             uint32_t n) {
        for (; n >= kLookInterval; n -= kLookInterval) runInterval(backend, data, contacts, params, ledger);
        for (; n > 0; --n) launch(backend.stream(), data, contacts, params, ledger);
    }

  private:
    /// All that is written into a graph and may change.
    using Key = std::array<uint64_t, 14>;
    struct Recorded {
        Key key;
        cudaGraphExec_t graph = nullptr;
    };
    static constexpr size_t kGraphs = 8, kSeen = 16;

    static Key keyOf(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, bool ledger) {
        const auto address = [](const auto& span) { return reinterpret_cast<uint64_t>(span.data); };
        const auto bits = [](Real value) {
            return static_cast<uint64_t>(std::bit_cast<uint32_t>(float(value)));
        };
        return {address(arrays.in.position),
                address(arrays.contact_row),
                address(arrays.neighbour),
                address(arrays.contact_spring),
                address(arrays.body_laws),
                address(arrays.pair_laws),
                address(arrays.wall_laws),
                bits(params.gravity.x),
                bits(params.gravity.y),
                bits(params.gravity.z),
                bits(params.velocity_keep),
                params.breaking,
                bits(params.dt),
                uint64_t{ledger}};
    }

    void runInterval(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
                     ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params,
                     bool ledger) {
        static_assert(kLookInterval % 2 == 0, "a graph must end on the state it started from");
        const Key key = keyOf(data.arrays(contacts), params, ledger);
        const auto recorded =
            std::find_if(graphs_.begin(), graphs_.end(), [&](const Recorded& r) { return r.key == key; });
        if (recorded != graphs_.end()) {
            checkCuda(cudaGraphLaunch(recorded->graph, backend.stream()), "starting substeps");
            return;
        }
        // Worth recording only when the same is asked for again.
        const bool again = std::find(seen_.begin(), seen_.end(), key) != seen_.end();
        if (again) {
            record(backend, data, contacts, params, ledger, key);
            checkCuda(cudaGraphLaunch(graphs_.back().graph, backend.stream()), "starting substeps");
            return;
        }
        if (seen_.size() >= kSeen) seen_.erase(seen_.begin());
        seen_.push_back(key);
        for (uint32_t k = 0; k < kLookInterval; ++k) launch(backend.stream(), data, contacts, params, ledger);
    }

    void record(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
                ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
                const Key& key) {
        if (graphs_.size() >= kGraphs) {
            backend.synchronize();
            cudaGraphExecDestroy(graphs_.front().graph);
            graphs_.erase(graphs_.begin());
        }
        cudaGraph_t graph = nullptr;
        checkCuda(cudaStreamBeginCapture(backend.stream(), cudaStreamCaptureModeThreadLocal),
                  "recording substeps");
        for (uint32_t k = 0; k < kLookInterval; ++k) launch(backend.stream(), data, contacts, params, ledger);
        checkCuda(cudaStreamEndCapture(backend.stream(), &graph), "recording substeps");
        Recorded recorded{key, nullptr};
        const cudaError_t made = cudaGraphInstantiate(&recorded.graph, graph, 0);
        cudaGraphDestroy(graph);
        checkCuda(made, "recording substeps");
        graphs_.push_back(recorded);
    }

    void launch(cudaStream_t stream, SolverData<CudaBackend, Real>& data,
                ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params, bool ledger) {
        const SubstepArrays<Real> arrays = data.arrays(contacts);
        ledger ? launchWith<true>(stream, arrays, params) : launchWith<false>(stream, arrays, params);
        checkCuda(cudaGetLastError(), "starting a substep");
        data.current = 1 - data.current;
    }

    template <bool kLedger>
    static void launchWith(cudaStream_t stream, const SubstepArrays<Real>& arrays,
                           const StepParams<Real>& params) {
        switch (threadsPerParticle(params.in_bodies)) {
            case 1:
                return launchT<1, kLedger>(stream, arrays, params);
            case 2:
                return launchT<2, kLedger>(stream, arrays, params);
            case 4:
                return launchT<4, kLedger>(stream, arrays, params);
            case 8:
                return launchT<8, kLedger>(stream, arrays, params);
            default:
                return launchT<16, kLedger>(stream, arrays, params);
        }
    }

    template <uint32_t T, bool kLedger>
    static void launchT(cudaStream_t stream, const SubstepArrays<Real>& arrays,
                        const StepParams<Real>& params) {
        constexpr uint32_t kParticles = kSubstepBlock / T;
        const uint32_t blocks = (params.in_bodies + kParticles - 1) / kParticles + kMaxProjectiles;
        substepKernel<T, kLedger, Real><<<blocks, kSubstepBlock, 0, stream>>>(arrays, params);
    }

    std::vector<Recorded> graphs_;
    std::vector<Key> seen_;
};

}  // namespace demolish
