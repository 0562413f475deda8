// SPDX-License-Identifier: Apache-2.0
// The GPU: device memory, one stream, kernels from function objects. Compiled by nvcc only. No stream here
// waits for the legacy stream, which is not used anywhere: work on it while another thread records a graph
// would end the recording.
#pragma once
#include <cuda_runtime.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/backend/cuda_chained_launch.cuh"
#include "sim_cuda/backend/cuda_error.h"
#include "sim_cuda/backend/cuda_steps.cuh"
#include "sim_cuda/backend/reduction.h"
#include "sim_cuda/backend/span.h"

namespace demolish {

inline constexpr unsigned kCudaBlock = 128;

/// __grid_constant__, here and below: what takes an address of it finds it in place. A copy on the stack, of
/// which some would need more than a kibibyte a thread, made every launch wait for memory.
template <class Kernel>
__global__ void __launch_bounds__(kCudaBlock) runForEach(uint32_t n, const __grid_constant__ Kernel kernel) {
    letNextStart();
    awaitPrevious();
    const uint32_t i = blockIdx.x * kCudaBlock + threadIdx.x;
    if (i < n) kernel(i);
}

/// One block folds one chunk, in the order of reduction.h.
template <class T, class Map, class Fold>
__global__ void __launch_bounds__(kReductionChunk)
    runReduce(uint32_t n, T zero, const __grid_constant__ Map map, Fold fold, T* partial) {
    __shared__ alignas(T) unsigned char memory[kReductionChunk * sizeof(T)];
    letNextStart();
    awaitPrevious();
    T* lane = reinterpret_cast<T*>(memory);
    const uint32_t l = threadIdx.x, i = blockIdx.x * kReductionChunk + l;
    lane[l] = i < n ? map(i) : zero;
    for (uint32_t step = kReductionChunk / 2; step > 0; step /= 2) {
        __syncthreads();
        if (l < step) fold(lane[l], lane[l + step]);
    }
    if (l == 0) partial[blockIdx.x] = lane[0];
}

template <class T>
struct ElementOf {
    const T* values;
    DEM_FN T operator()(uint32_t i) const { return values[i]; }
};

class CudaBackend {
  public:
    static constexpr bool kOnGpu = true;

    /// On the current device. Throws DeviceError without a usable GPU.
    CudaBackend();
    ~CudaBackend();
    CudaBackend(const CudaBackend&) = delete;
    CudaBackend& operator=(const CudaBackend&) = delete;

    /// Owns n elements of device memory. Move-only; empty by default. T is trivially copyable.
    template <class T>
    class Buffer {
      public:
        Buffer() = default;
        explicit Buffer(size_t n) : count_(n) {
            if (n > 0) checkCuda(cudaMalloc(&memory_, n * sizeof(T)), "allocating memory");
        }
        Buffer(Buffer&& other) noexcept
            : memory_(std::exchange(other.memory_, nullptr)), count_(std::exchange(other.count_, 0)) {}
        Buffer& operator=(Buffer&& other) noexcept {
            std::swap(memory_, other.memory_);
            std::swap(count_, other.count_);
            return *this;
        }
        ~Buffer() { cudaFree(memory_); }
        size_t size() const { return count_; }
        Span<T> span() { return {static_cast<T*>(memory_), count_}; }
        Span<const T> span() const { return {static_cast<const T*>(memory_), count_}; }
        Span<const T> view() const { return {static_cast<const T*>(memory_), count_}; }

      private:
        void* memory_ = nullptr;
        size_t count_ = 0;
    };

    /// n elements, all bits zero.
    template <class T>
    Buffer<T> allocate(size_t n) {
        Buffer<T> buffer(n);
        if (n > 0)
            checkCuda(cudaMemsetAsync(buffer.span().data, 0, n * sizeof(T), stream_), "clearing memory");
        return buffer;
    }
    template <class T>
    Buffer<T> uploaded(const std::vector<T>& values) {
        Buffer<T> buffer(values.size());
        upload(buffer.span(), values.data(), values.size());
        return buffer;
    }
    template <class T>
    void upload(Span<T> to, const T* from, size_t n) {
        if (n > 0) transfer(to.data, from, n * sizeof(T), cudaMemcpyHostToDevice);
    }
    /// Waits for what was started before.
    template <class T>
    void download(Span<const T> from, T* to) {
        if (alignof(T) >= sizeof(uint32_t) && from.count > 0 &&
            from.count * sizeof(T) <= Reader::kWords * sizeof(uint32_t))
            return readWords(from.data, from.count * sizeof(T), to);
        if (from.count > 0) transfer(to, from.data, from.count * sizeof(T), cudaMemcpyDeviceToHost);
        synchronize();
    }
    template <class T>
    std::vector<std::remove_const_t<T>> downloaded(Span<T> from) {
        std::vector<std::remove_const_t<T>> values(from.count);
        download(Span<const std::remove_const_t<T>>(from.data, from.count), values.data());
        return values;
    }
    /// Device to device; the sizes are the same.
    template <class T>
    void copy(Span<const T> from, Span<T> to) {
        if (from.count > 0) transfer(to.data, from.data, from.count * sizeof(T), cudaMemcpyDeviceToDevice);
    }
    template <class T>
    struct FillKernel {
        Span<T> to;
        T value;
        DEM_FN void operator()(uint32_t i) const { to[i] = value; }
    };
    template <class T>
    void fill(Span<T> to, const T& value) {
        forEach(to.count, FillKernel<T>{to, value}, "fill");
    }

    /// kernel(i) for i in 0..n-1, in any order and at the same time, after what was started before. Does not
    /// wait.
    template <class Kernel>
    void forEach(size_t n, const Kernel& kernel, const char* name) {
        if (n == 0) return;
        const auto blocks = static_cast<unsigned>((n + kCudaBlock - 1) / kCudaBlock);
        launch(true, runForEach<Kernel>, blocks, kCudaBlock, name, static_cast<uint32_t>(n), kernel);
    }

    /// kernel(ids[k], step) for all k below count[0] at the same time, for step = 0, 1 ... steps-1, one after
    /// the other, until kernel.isOver(step). Does not wait; not inside a graph that is being recorded.
    template <class Kernel>
    void forEachInSteps(Span<const uint32_t> ids, Span<const uint32_t> count, uint32_t steps,
                        const Kernel& kernel, const char* name) {
        uint32_t* words = steps_barrier_.span().data;
        const StepsBarrier barrier{words, words + 1};
        if (ids.count > 0) launchSteps(stream_, multiprocessors_, ids, count, steps, kernel, barrier, name);
    }

    /// A kernel that calls letNextStart() and awaitPrevious(); `follows` as in LaunchShape. Throws on
    /// failure.
    template <class... Parameters, class... Arguments>
    void launch(bool follows, void (*kernel)(Parameters...), dim3 blocks, uint32_t threads, const char* name,
                const Arguments&... arguments) {
        const bool alone = list_ == nullptr && std::exchange(waits_for_side_, false);
        const KernelOf<Parameters...> described(kernel, blocks, threads, follows && !alone);
        list_ != nullptr ? described.addTo(*list_, arguments...)
                         : described.launch(stream_, name, arguments...);
    }
    /// Adds what `launches` launches, and nothing else, to the list instead.
    template <class Launches>
    void collect(LaunchList& list, const Launches& launches) {
        const struct Until {
            LaunchList*& list;
            ~Until() { list = nullptr; }
        } until{list_};
        list_ = &list;
        launches();
    }

    /// What main() starts and what side() starts, at the same time, after what was started before; what is
    /// started later comes after both. Neither writes what the other one reads or writes.
    template <class Main, class Side>
    void sideBySide(const Main& main, const Side& side) {
        checkCuda(cudaEventRecord(forked_, stream_), "starting work beside other work");
        main();
        checkCuda(cudaStreamWaitEvent(side_stream_, forked_), "starting work beside other work");
        {
            const OnSideStream on_side(*this);
            side();
        }
        checkCuda(cudaEventRecord(joined_, side_stream_), "waiting for work beside other work");
        checkCuda(cudaStreamWaitEvent(stream_, joined_), "waiting for work beside other work");
    }

    /// out[k] = in[0] + ... + in[k-1] for k = 0..n; out has n + 1 elements. `in` and `out` may be the same
    /// memory. Does not wait; not inside a graph that is being recorded.
    void exclusiveScan(Span<const uint32_t> in, Span<uint32_t> out);

    /// order = 0 .. n-1 sorted by (key, id); keys are below n. Does not wait.
    void orderByKey(Span<const uint32_t> key, Span<uint32_t> order);

    /// Folds map(0) .. map(n-1) in the order of reduction.h; `zero` where n is 0 and as the neutral element.
    /// Waits.
    template <class T, class Map, class Fold>
    T reduce(size_t n, const T& zero, const Map& map, const Fold& fold, const char* name) {
        if (n == 0) return zero;
        T result;
        download(Span<const T>(startReduce(n, zero, map, fold, static_cast<T*>(nullptr), name), 1), &result);
        return result;
    }
    /// The same into result[0] on the device, n > 0. Does not wait.
    template <class T, class Map, class Fold>
    void reduceInto(Span<T> result, size_t n, const T& zero, const Map& map, const Fold& fold,
                    const char* name) {
        startReduce(n, zero, map, fold, result.data, name);
    }

    /// Throws DeviceError when anything since the last call failed.
    void synchronize() { checkCuda(cudaStreamSynchronize(stream_), "waiting for the GPU"); }
    std::string deviceName() const { return device_name_; }
    cudaStream_t stream() const { return stream_; }
    int multiprocessors() const { return multiprocessors_; }

    /// Words that come back while later work goes on. A kernel writes them into the host's memory: a copy of
    /// some bytes keeps the GPU waiting for ten microseconds.
    class Reader {
      public:
        explicit Reader(CudaBackend& backend);
        ~Reader();
        Reader(const Reader&) = delete;
        Reader& operator=(const Reader&) = delete;
        /// Reads at most kWords words as they are after what was started before.
        void start(CudaBackend& backend, Span<const uint32_t> words);
        /// The same, and sets them to 0.
        void take(CudaBackend& backend, Span<uint32_t> words);
        /// Waits for them, and not for what was started later.
        const std::vector<uint32_t>& wait();

        static constexpr size_t kWords = 12;

      private:
        void send(CudaBackend& backend, Span<const uint32_t> words, uint32_t* cleared);

        cudaStream_t stream_ = nullptr;
        uint32_t* pinned_ = nullptr;  ///< kWords, then how often something was sent
        uint32_t sent_ = 0;
        std::vector<uint32_t> words_;
    };

    /// Stopwatch over work started on this backend.
    class Timer {
      public:
        Timer();
        ~Timer();
        Timer(const Timer&) = delete;
        Timer& operator=(const Timer&) = delete;
        void start(CudaBackend& backend) { checkCuda(cudaEventRecord(start_, backend.stream_), "timing"); }
        void stop(CudaBackend& backend) { checkCuda(cudaEventRecord(stop_, backend.stream_), "timing"); }
        /// s; waits for the work between start and stop.
        double seconds() const;

      private:
        cudaEvent_t start_ = nullptr, stop_ = nullptr;
    };

  private:
    /// A few whole words: sooner than a copy.
    void readWords(const void* from, size_t bytes, void* to);
    /// Memory for one scan or reduction, kept for the next.
    void* scratch(size_t bytes);
    void transfer(void* to, const void* from, size_t bytes, cudaMemcpyKind kind) {
        checkCuda(cudaMemcpyAsync(to, from, bytes, kind, stream_), "copying memory");
    }
    /// Where the result will lie: `result`, or scratch memory where that is null.
    template <class T, class Map, class Fold>
    const T* startReduce(size_t n, const T& zero, const Map& map, const Fold& fold, T* result,
                         const char* name) {
        size_t chunks = (n + kReductionChunk - 1) / kReductionChunk;
        T* partial = static_cast<T*>(scratch(2 * chunks * sizeof(T)));
        T* next = partial + chunks;
        if (chunks == 1 && result != nullptr) partial = result;
        launchReduce(n, chunks, zero, map, fold, partial, name);
        while (chunks > 1) {
            const size_t count = chunks;
            chunks = (count + kReductionChunk - 1) / kReductionChunk;
            if (chunks == 1 && result != nullptr) next = result;
            launchReduce(count, chunks, zero, ElementOf<T>{partial}, fold, next, name);
            std::swap(partial, next);
        }
        return partial;
    }
    template <class T, class Map, class Fold>
    void launchReduce(size_t n, size_t chunks, const T& zero, const Map& map, const Fold& fold, T* partial,
                      const char* name) {
        launch(true, runReduce<T, Map, Fold>, static_cast<unsigned>(chunks), kReductionChunk, name,
               static_cast<uint32_t>(n), zero, map, fold, partial);
    }

    /// What is started meanwhile goes to the other stream. The first launch on either stream follows nothing.
    class OnSideStream {
      public:
        explicit OnSideStream(CudaBackend& backend) : backend_(backend) { exchange(); }
        ~OnSideStream() { exchange(); }
        OnSideStream(const OnSideStream&) = delete;
        OnSideStream& operator=(const OnSideStream&) = delete;

      private:
        void exchange() {
            std::swap(backend_.stream_, backend_.side_stream_);
            backend_.waits_for_side_ = true;
        }
        CudaBackend& backend_;
    };

    cudaStream_t stream_ = nullptr, side_stream_ = nullptr;
    cudaEvent_t forked_ = nullptr, joined_ = nullptr;
    bool waits_for_side_ = false;  ///< the next launch waits for another stream, not only for the one before
    LaunchList* list_ = nullptr;   ///< where launches go while they are collected
    std::string device_name_;
    int multiprocessors_ = 0;
    Buffer<unsigned char> scratch_;
    Buffer<uint32_t> steps_barrier_;
    std::unique_ptr<Reader> few_words_;
};

}  // namespace demolish
