// SPDX-License-Identifier: Apache-2.0
// Launches, graphs and clocks of the floor's substep.
#include <algorithm>
#include <array>
#include <functional>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/solver.h"
#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/backend/cuda_backend.cuh"
#include "sim_cuda/bench/floor_kernels.cuh"
#include "sim_cuda/bench/floor_schemes.h"

namespace demolish {
namespace {

constexpr uint32_t kBatch = 100;        // substeps of a graph or of a resident launch
constexpr double kLeastSeconds = 2e-3;  // of one timing
constexpr int kMostBatches = 20, kRepeats = 5;
constexpr size_t kCopyBytes = size_t{1} << 30;

/// Bonds in transposed rows: a warp's slots side by side, its rows filled up to the longest.
struct TransposedRows {
    std::vector<uint32_t> warp{0}, other;
    std::vector<FloorRest> rest;

    explicit TransposedRows(const FloorProblem& problem) {
        const auto count = static_cast<uint32_t>(problem.states.size());
        for (uint32_t first = 0; first < count; first += kWarp) {
            const uint32_t last = std::min(first + kWarp, count);
            uint32_t longest = 0;
            for (uint32_t i = first; i < last; ++i)
                longest = std::max(longest, problem.row[i + 1] - problem.row[i]);
            const size_t start = other.size();
            other.resize(start + size_t{longest} * kWarp, kNoOther);
            rest.resize(other.size());
            for (uint32_t i = first; i < last; ++i)
                for (uint32_t k = 0; k < problem.row[i + 1] - problem.row[i]; ++k) {
                    other[start + k * kWarp + (i - first)] = problem.other[problem.row[i] + k];
                    rest[start + k * kWarp + (i - first)] = problem.rest[problem.row[i] + k];
                }
            warp.push_back(static_cast<uint32_t>(other.size()));
        }
    }
};

/// A problem in device memory.
class FloorOnGpu {
  public:
    explicit FloorOnGpu(const FloorProblem& problem)
        : problem_(problem), count_(static_cast<uint32_t>(problem.states.size())) {
        for (auto& memory : state_) memory = backend_.allocate<Vec4<float>>(size_t{4} * count_);
        row_ = backend_.uploaded(problem.row);
        other_ = backend_.uploaded(problem.other);
        rest_ = backend_.uploaded(problem.rest);
        const TransposedRows transposed(problem);
        warp_ = backend_.uploaded(transposed.warp);
        other_of_warp_ = backend_.uploaded(transposed.other);
        rest_of_warp_ = backend_.uploaded(transposed.rest);
        start();
    }

    /// Back to the problem's start.
    void start() {
        std::vector<Vec4<float>> values(size_t{4} * count_);
        for (uint32_t i = 0; i < count_; ++i) {
            const FloorState& state = problem_.states[i];
            values[i] = withW(state.position, 0.0f);
            values[count_ + i] = asVec4(state.rotation);
            values[2 * size_t{count_} + i] = withW(state.velocity, 0.0f);
            values[3 * size_t{count_} + i] = withW(state.spin, 0.0f);
        }
        backend_.upload(state_[0].span(), values.data(), values.size());
        backend_.synchronize();
    }

    std::vector<FloorState> states() {
        const auto values = backend_.downloaded(state_[0].span());
        std::vector<FloorState> states(count_);
        for (size_t i = 0; i < count_; ++i)
            states[i] = {xyz(values[i]), asQuat(values[count_ + i]), xyz(values[2 * size_t{count_} + i]),
                         xyz(values[3 * size_t{count_} + i])};
        return states;
    }

    FloorArrays rows(bool backwards) {
        return {arraysOf(backwards), arraysOf(!backwards), row_.span().data,
                other_.span().data,  rest_.span().data,    count_,
                problem_.constants};
    }
    FloorArrays transposed(bool backwards) {
        return {arraysOf(backwards),        arraysOf(!backwards),      warp_.span().data,
                other_of_warp_.span().data, rest_of_warp_.span().data, count_,
                problem_.constants};
    }

    CudaBackend& backend() { return backend_; }
    const FloorProblem& problem() const { return problem_; }
    uint32_t count() const { return count_; }

  private:
    FloorStateArrays arraysOf(bool second) {
        Vec4<float>* first = state_[second ? 1 : 0].span().data;
        const size_t n = count_;
        return {first, first + n, first + 2 * n, first + 3 * n};
    }

    const FloorProblem& problem_;
    uint32_t count_;
    CudaBackend backend_;
    std::array<CudaBackend::Buffer<Vec4<float>>, 2> state_;
    CudaBackend::Buffer<uint32_t> row_, other_, warp_, other_of_warp_;
    CudaBackend::Buffer<FloorRest> rest_, rest_of_warp_;
};

/// `run` enqueues an even number of substeps.
struct Scheme {
    std::string name;
    std::function<void(FloorOnGpu&, uint32_t substeps)> run;
    bool in_graph;
};

template <uint32_t T>
Scheme rowsScheme() {
    const auto run = [](FloorOnGpu& gpu, uint32_t substeps) {
        const uint32_t blocks = (gpu.count() * T + kFloorBlock - 1) / kFloorBlock;
        for (uint32_t k = 0; k < substeps; ++k)
            floorRows<T><<<blocks, kFloorBlock, 0, gpu.backend().stream()>>>(gpu.rows(k % 2 == 1));
        checkCuda(cudaGetLastError(), "starting the floor's substep");
    };
    const std::string threads = T == 1 ? "1 thread" : std::to_string(T) + " threads";
    return {"graph, " + threads + " a particle", run, true};
}

Scheme transposedScheme() {
    const auto run = [](FloorOnGpu& gpu, uint32_t substeps) {
        const uint32_t blocks = (gpu.count() + kFloorBlock - 1) / kFloorBlock;
        for (uint32_t k = 0; k < substeps; ++k)
            floorTransposed<<<blocks, kFloorBlock, 0, gpu.backend().stream()>>>(gpu.transposed(k % 2 == 1));
        checkCuda(cudaGetLastError(), "starting the floor's substep");
    };
    return {"graph, 1 thread a particle, bonds transposed", run, true};
}

/// How a resident launch divides the particles; per_block 0: it does not fit.
struct ResidentShape {
    uint32_t blocks = 0, per_block = 0;
    size_t shared_bytes = 0;
};

template <uint32_t T>
ResidentShape residentShape(const FloorOnGpu& gpu, int multiprocessors, uint32_t threads) {
    const FloorProblem& problem = gpu.problem();
    ResidentShape shape;
    shape.blocks = static_cast<uint32_t>(multiprocessors);
    shape.per_block = (gpu.count() + shape.blocks - 1) / shape.blocks;
    for (uint32_t first = 0; first < gpu.count(); first += shape.per_block) {
        const uint32_t last = std::min(first + shape.per_block, gpu.count());
        const size_t slots = problem.row[last] - problem.row[first];
        shape.shared_bytes = std::max(shape.shared_bytes, slots * (sizeof(FloorRest) + sizeof(uint32_t)));
    }
    int device = 0, most_shared = 0, resident = 0;
    checkCuda(cudaGetDevice(&device), "looking for a GPU");
    checkCuda(cudaDeviceGetAttribute(&most_shared, cudaDevAttrMaxSharedMemoryPerBlockOptin, device),
              "asking for the shared memory's size");
    if (shape.shared_bytes > static_cast<size_t>(most_shared)) return {};
    checkCuda(
        cudaFuncSetAttribute(floorResident<T>, cudaFuncAttributeMaxDynamicSharedMemorySize, most_shared),
        "asking for shared memory");
    checkCuda(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&resident, floorResident<T>,
                                                            static_cast<int>(threads), shape.shared_bytes),
              "asking for the occupancy");
    return resident > 0 ? shape : ResidentShape{};
}

template <uint32_t T>
void addResidentSchemes(FloorOnGpu& gpu, std::vector<Scheme>& schemes) {
    for (const uint32_t threads : {256u, 512u, 1024u}) {
        const ResidentShape shape = residentShape<T>(gpu, gpu.backend().multiprocessors(), threads);
        if (shape.per_block == 0) continue;
        const auto run = [shape, threads](FloorOnGpu& on, uint32_t substeps) {
            FloorArrays arrays = on.rows(false);
            uint32_t per_block = shape.per_block;
            void* arguments[] = {&arrays, &per_block, &substeps};
            checkCuda(cudaLaunchCooperativeKernel(reinterpret_cast<void*>(floorResident<T>),
                                                  dim3(shape.blocks), dim3(threads), arguments,
                                                  shape.shared_bytes, on.backend().stream()),
                      "starting the floor's substeps");
        };
        schemes.push_back({"resident, bonds in shared memory, " + std::to_string(T) +
                               " threads a particle, " + std::to_string(threads) + " a block",
                           run, false});
    }
}

std::vector<Scheme> schemesFor(FloorOnGpu& gpu) {
    std::vector<Scheme> schemes{transposedScheme(), rowsScheme<1>(), rowsScheme<2>(),
                                rowsScheme<4>(),    rowsScheme<8>(), rowsScheme<16>()};
    addResidentSchemes<4>(gpu, schemes);
    addResidentSchemes<8>(gpu, schemes);
    addResidentSchemes<16>(gpu, schemes);
    return schemes;
}

/// A recorded batch, launched as a whole.
class BatchGraph {
  public:
    BatchGraph(FloorOnGpu& gpu, const Scheme& scheme) {
        const cudaStream_t stream = gpu.backend().stream();
        cudaGraph_t graph = nullptr;
        checkCuda(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "recording substeps");
        scheme.run(gpu, kBatch);
        checkCuda(cudaStreamEndCapture(stream, &graph), "recording substeps");
        const cudaError_t made = cudaGraphInstantiate(&graph_, graph, 0);
        cudaGraphDestroy(graph);
        checkCuda(made, "recording substeps");
    }
    ~BatchGraph() { cudaGraphExecDestroy(graph_); }
    BatchGraph(const BatchGraph&) = delete;
    BatchGraph& operator=(const BatchGraph&) = delete;

    void launch(cudaStream_t stream) const {
        checkCuda(cudaGraphLaunch(graph_, stream), "starting substeps");
    }

  private:
    cudaGraphExec_t graph_ = nullptr;
};

/// s for one call of `work`: the median of kRepeats timings of as many calls as make a readable time.
double timed(CudaBackend& backend, const std::function<void()>& work) {
    CudaBackend::Timer timer;
    const auto secondsOf = [&](int calls) {
        timer.start(backend);
        for (int k = 0; k < calls; ++k) work();
        timer.stop(backend);
        return timer.seconds() / calls;
    };
    secondsOf(1);  // the first call loads what it needs
    const double once = secondsOf(1);
    const int calls = std::clamp(static_cast<int>(kLeastSeconds / std::max(once, 1e-9)), 1, kMostBatches);
    std::array<double, kRepeats> seconds{};
    for (auto& value : seconds) value = secondsOf(calls);
    std::sort(seconds.begin(), seconds.end());
    return seconds[kRepeats / 2];
}

double secondsOfBatch(FloorOnGpu& gpu, const Scheme& scheme) {
    if (!scheme.in_graph) return timed(gpu.backend(), [&] { scheme.run(gpu, kBatch); });
    const BatchGraph graph(gpu, scheme);
    return timed(gpu.backend(), [&] { graph.launch(gpu.backend().stream()); });
}

/// bytes/s, read and written together.
double copyBandwidth(CudaBackend& backend) {
    const auto from = backend.allocate<unsigned char>(kCopyBytes);
    auto to = backend.allocate<unsigned char>(kCopyBytes);
    return 2 * static_cast<double>(kCopyBytes) /
           timed(backend, [&] { backend.copy(from.span(), to.span()); });
}

void requireGpu() {
    const CudaDevice device = findCudaDevice();
    if (!device.usable) throw DeviceError("No usable GPU: " + device.problem + "; use --device cpu.");
}

}  // namespace

SubstepFloor cudaSubstepFloor(const BreakableBody& body) {
    requireGpu();
    const FloorProblem problem = makeFloorProblem(body);
    FloorOnGpu gpu(problem);
    SubstepFloor floor;
    floor.bytes = bytesOfSubstep(body.particles.size(), body.bonds.size());
    floor.copy_bandwidth = copyBandwidth(gpu.backend());
    floor.memory_us = 1e6 * floor.bytes / floor.copy_bandwidth;
    for (const auto& scheme : schemesFor(gpu)) {
        gpu.start();
        floor.schemes.push_back({scheme.name, 1e6 * secondsOfBatch(gpu, scheme) / kBatch});
    }
    floor.bonds_us =
        std::min_element(floor.schemes.begin(), floor.schemes.end(), [](const auto& a, const auto& b) {
            return a.microseconds < b.microseconds;
        })->microseconds;
    return floor;
}

std::vector<FloorOutcome> cudaFloorOutcomes(const FloorProblem& problem, uint32_t substeps) {
    requireGpu();
    FloorOnGpu gpu(problem);
    std::vector<FloorOutcome> outcomes;
    for (const auto& scheme : schemesFor(gpu)) {
        gpu.start();
        scheme.run(gpu, substeps);
        gpu.backend().synchronize();
        outcomes.push_back({scheme.name, gpu.states()});
    }
    return outcomes;
}

}  // namespace demolish
