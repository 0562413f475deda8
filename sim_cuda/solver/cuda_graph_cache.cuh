// Sequences of launches kept as CUDA graphs: recorded when the same is asked for a second time.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "sim_cuda/backend/cuda_backend.cuh"

namespace demolish {

/// All that is written into a graph and may change.
using GraphKey = std::vector<uint64_t>;

template <class T>
uint64_t keyWord(const Span<T>& span) {
    return reinterpret_cast<uint64_t>(span.data);
}
inline uint64_t keyWord(double value) {
    return std::bit_cast<uint64_t>(value);
}

class CudaGraphCache {
  public:
    CudaGraphCache() = default;
    ~CudaGraphCache() {
        for (const Recorded& recorded : graphs_) cudaGraphExecDestroy(recorded.graph);
    }
    CudaGraphCache(const CudaGraphCache&) = delete;
    CudaGraphCache& operator=(const CudaGraphCache&) = delete;

    /// Does what `launch` launches on the backend's stream, by a graph where there is one for the key.
    /// `launch` must launch the same for the same key. Does not wait.
    template <class Launch>
    void run(CudaBackend& backend, const GraphKey& key, const Launch& launch) {
        const auto recorded =
            std::find_if(graphs_.begin(), graphs_.end(), [&](const Recorded& r) { return r.key == key; });
        if (recorded != graphs_.end()) return start(backend, *recorded);
        // Worth recording only when the same is asked for again.
        if (std::find(seen_.begin(), seen_.end(), key) != seen_.end()) {
            record(backend, key, launch);
            return start(backend, graphs_.back());
        }
        if (seen_.size() >= kSeen) seen_.erase(seen_.begin());
        seen_.push_back(key);
        launch();
    }

  private:
    struct Recorded {
        GraphKey key;
        cudaGraphExec_t graph = nullptr;
    };
    static constexpr size_t kGraphs = 16, kSeen = 32;

    static void start(CudaBackend& backend, const Recorded& recorded) {
        checkCuda(cudaGraphLaunch(recorded.graph, backend.stream()), "starting substeps");
    }

    template <class Launch>
    void record(CudaBackend& backend, const GraphKey& key, const Launch& launch) {
        if (graphs_.size() >= kGraphs) {
            backend.synchronize();
            cudaGraphExecDestroy(graphs_.front().graph);
            graphs_.erase(graphs_.begin());
        }
        cudaGraph_t graph = nullptr;
        checkCuda(cudaStreamBeginCapture(backend.stream(), cudaStreamCaptureModeThreadLocal),
                  "recording substeps");
        launch();
        checkCuda(cudaStreamEndCapture(backend.stream(), &graph), "recording substeps");
        Recorded recorded{key, nullptr};
        const cudaError_t made = cudaGraphInstantiate(&recorded.graph, graph, 0);
        cudaGraphDestroy(graph);
        checkCuda(made, "recording substeps");
        graphs_.push_back(recorded);
    }

    std::vector<Recorded> graphs_;
    std::vector<GraphKey> seen_;
};

/// A number of threads' items not below n that takes few values: graphs are recorded for it.
inline uint32_t roundedUp(uint32_t n) {
    const uint32_t step = std::max(256u, std::bit_floor(std::max(n, 1u)) / 4);
    return (n + step - 1) / step * step;
}

}  // namespace demolish
