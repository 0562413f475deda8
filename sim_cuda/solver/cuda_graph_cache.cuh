// Sequences of launches kept as CUDA graphs: recorded when the same has been asked for several
// times.
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
        if (recorded != graphs_.end()) {
            std::rotate(recorded, recorded + 1, graphs_.end());
        } else if (isWorthIt(key)) {
            record(backend, key, launch);
        } else {
            return launch();
        }
        checkCuda(cudaGraphLaunch(graphs_.back().graph, backend.stream()), "starting substeps");
    }

  private:
    struct Recorded {
        GraphKey key;
        cudaGraphExec_t graph = nullptr;
    };
    struct Seen {
        GraphKey key;
        uint32_t times = 0;
    };
    /// The longest not used go first. While many things break hardly any sequence comes again.
    static constexpr size_t kGraphs = 96, kSeen = 192;
    /// Recording takes as long as some ten sequences of single launches.
    static constexpr uint32_t kTimesBefore = 6;

    bool isWorthIt(const GraphKey& key) {
        const auto seen =
            std::find_if(seen_.begin(), seen_.end(), [&](const Seen& s) { return s.key == key; });
        if (seen == seen_.end()) {
            if (seen_.size() >= kSeen) seen_.erase(seen_.begin());
            seen_.push_back({key, 1});
            return false;
        }
        std::rotate(seen, seen + 1, seen_.end());
        return seen_.back().times++ >= kTimesBefore;
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
    std::vector<Seen> seen_;
};

/// A number of threads' items not below n that takes few values, for each of which a graph is recorded:
/// items too many end at once, and cost less than recording does.
inline uint32_t roundedUp(uint32_t n, uint32_t least = 256) {
    return std::max(least, std::bit_ceil(n));
}

}  // namespace demolish
