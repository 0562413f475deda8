// SPDX-License-Identifier: Apache-2.0
// Sequences of launches as CUDA graphs. A graph takes the host a microsecond to start, each launch of its own
// two and a half or more, while a substep of few particles takes the GPU two. Lists and counts change with
// every decision: then the arguments in a graph are changed, not the graph.
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "sim_cuda/backend/cuda_backend.cuh"

namespace demolish {

/// What the arguments of a sequence depend on.
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
        for (const Recorded& recorded : graphs_) {
            cudaGraphExecDestroy(recorded.ready);
            cudaGraphDestroy(recorded.graph);
        }
    }
    CudaGraphCache(const CudaGraphCache&) = delete;
    CudaGraphCache& operator=(const CudaGraphCache&) = delete;

    /// Does what `launch` launches on the backend: by launching it when the key is new, which starts soonest,
    /// from the second time on by a graph, whose arguments are changed while the first time is still being
    /// worked at. `launch` must launch the same for the same key. Does not wait.
    template <class Launch>
    void run(CudaBackend& backend, const GraphKey& key, const Launch& launch) {
        const auto known =
            std::find_if(graphs_.begin(), graphs_.end(), [&](const Recorded& r) { return r.key == key; });
        if (known != graphs_.end()) {
            std::rotate(known, known + 1, graphs_.end());
        } else if (key != seen_) {
            seen_ = key;
            return launch();
        } else {
            collect(backend, launch);
            prepare(backend);
            graphs_.back().key = key;
        }
        checkCuda(cudaGraphLaunch(graphs_.back().ready, backend.stream()), "starting substeps");
    }

    /// Records graphs for such a sequence, whatever its arguments: lists alternate between few places in
    /// memory, and their arguments need not be changed then.
    template <class Launch>
    void recordAhead(CudaBackend& backend, const Launch& launch) {
        constexpr uint32_t kAlike = 4;
        collect(backend, launch);
        for (uint32_t k = 0; k < kAlike; ++k) record(backend);
    }

  private:
    struct Recorded {
        GraphKey key;
        std::vector<LaunchShape> shapes;
        std::vector<cudaGraphNode_t> nodes;
        cudaGraph_t graph = nullptr;
        cudaGraphExec_t ready = nullptr;
    };
    template <class Launch>
    void collect(CudaBackend& backend, const Launch& launch) {
        list_.clear();
        backend.collect(list_, launch);
        list_.startAlone();
    }
    /// A graph for the list, the last of graphs_: the one of its kind that has not been used for longest and
    /// gets new arguments, or a new one. A change takes a hundredth of a millisecond, recording a tenth. What
    /// runs already is not affected.
    void prepare(CudaBackend& backend) {
        const auto alike = std::find_if(graphs_.begin(), graphs_.end(), [&](const Recorded& recorded) {
            if (recorded.shapes.size() != list_.size()) return false;
            for (size_t k = 0; k < list_.size(); ++k)
                if (!recorded.shapes[k].isLike(list_.shape(k))) return false;
            return true;
        });
        if (alike == graphs_.end()) return record(backend);
        std::rotate(alike, alike + 1, graphs_.end());
        Recorded& recorded = graphs_.back();
        for (size_t k = 0; k < list_.size(); ++k) {
            std::vector<void*> arguments = list_.arguments(k);
            cudaKernelNodeParams node{};
            node.func = const_cast<void*>(list_.shape(k).kernel);
            node.gridDim = list_.shape(k).blocks;
            node.blockDim = list_.shape(k).threads;
            node.kernelParams = arguments.data();
            checkCuda(cudaGraphExecKernelNodeSetParams(recorded.ready, recorded.nodes[k], &node),
                      "changing a graph");
        }
    }

    void record(CudaBackend& backend) {
        graphs_.emplace_back();
        Recorded& recorded = graphs_.back();
        cudaStream_t stream = backend.stream();
        checkCuda(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "recording substeps");
        for (size_t k = 0; k < list_.size(); ++k) {
            launchKernel(stream, list_.shape(k), list_.arguments(k).data(), "recording substeps");
            recorded.shapes.push_back(list_.shape(k));
            recorded.nodes.push_back(lastNode(stream));
        }
        checkCuda(cudaStreamEndCapture(stream, &recorded.graph), "recording substeps");
        checkCuda(cudaGraphInstantiate(&recorded.ready, recorded.graph, 0), "recording substeps");
    }
    /// Of what has been recorded on the stream.
    static cudaGraphNode_t lastNode(cudaStream_t stream) {
        cudaStreamCaptureStatus status{};
        const cudaGraphNode_t* nodes = nullptr;
        const cudaGraphEdgeData* edges = nullptr;
        size_t count = 0;
#if CUDART_VERSION >= 13000
        checkCuda(cudaStreamGetCaptureInfo(stream, &status, nullptr, nullptr, &nodes, &edges, &count),
                  "recording substeps");
#else
        checkCuda(cudaStreamGetCaptureInfo_v3(stream, &status, nullptr, nullptr, &nodes, &edges, &count),
                  "recording substeps");
#endif
        return nodes[count - 1];
    }

    std::vector<Recorded> graphs_;  ///< the one used last at the end
    GraphKey seen_;
    LaunchList list_;
};

/// A number of threads' items not below n that takes few values: items too many end at once, and cost less
/// than changing a graph does.
inline uint32_t roundedUp(uint32_t n, uint32_t least = 256) {
    return std::max(least, std::bit_ceil(n));
}

}  // namespace demolish
