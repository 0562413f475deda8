// SPDX-License-Identifier: Apache-2.0
// What of the CUDA backend needs no kernel of the caller: the stream, the prefix sum, the timer.
#include "sim_cuda/backend/cuda_backend.cuh"

#include <thrust/iterator/counting_iterator.h>
#include <thrust/iterator/transform_iterator.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>

#include <cub/block/block_reduce.cuh>
#include <cub/block/block_scan.cuh>
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

namespace demolish {
namespace {

/// in[0] .. in[n-1], then one zero: the sum up to there is the total.
struct WithZero {
    const uint32_t* in;
    size_t n;
    __host__ __device__ uint32_t operator()(size_t i) const { return i < n ? in[i] : 0u; }
};

/// Prefix sums of few numbers in one kernel: each block adds up all numbers before its own by itself. Two
/// launches of a general scan cost more than that.
constexpr unsigned kScanThreads = 1024, kScannedByThread = 4, kMostScanBlocks = 16;

__global__ void __launch_bounds__(kScanThreads) scanFew(const WithZero in, uint32_t* out) {
    using Sum = cub::BlockReduce<uint32_t, kScanThreads>;
    using Scan = cub::BlockScan<uint32_t, kScanThreads>;
    __shared__ typename Sum::TempStorage sum_memory;
    __shared__ typename Scan::TempStorage scan_memory;
    __shared__ uint32_t sum_before;
    letNextStart();
    awaitPrevious();
    const unsigned block_first = blockIdx.x * kScanThreads * kScannedByThread;
    const unsigned first = block_first + threadIdx.x * kScannedByThread;
    uint32_t own[kScannedByThread], before = 0;
#pragma unroll
    for (unsigned k = 0; k < kScannedByThread; ++k) own[k] = in(first + k);
    for (unsigned i = threadIdx.x; i < block_first; i += kScanThreads) before += in.in[i];
    before = Sum(sum_memory).Sum(before);
    if (threadIdx.x == 0) sum_before = before;
    Scan(scan_memory).ExclusiveSum(own, own);
    __syncthreads();
#pragma unroll
    for (unsigned k = 0; k < kScannedByThread; ++k)
        if (first + k <= in.n) out[first + k] = sum_before + own[k];
}

}  // namespace

CudaBackend::CudaBackend() {
    int device = 0;
    checkCuda(cudaGetDevice(&device), "looking for a GPU");
    cudaDeviceProp properties{};
    checkCuda(cudaGetDeviceProperties(&properties, device), "asking for the GPU's name");
    device_name_ = properties.name;
    multiprocessors_ = properties.multiProcessorCount;
    for (cudaStream_t* stream : {&stream_, &side_stream_})
        checkCuda(cudaStreamCreateWithFlags(stream, cudaStreamNonBlocking), "making a stream");
    for (cudaEvent_t* event : {&forked_, &joined_})
        checkCuda(cudaEventCreateWithFlags(event, cudaEventDisableTiming), "making an event");
    steps_barrier_ = allocate<uint32_t>(2);
    few_words_ = std::make_unique<Reader>(*this);
}

CudaBackend::~CudaBackend() {
    few_words_.reset();  // it waits for the stream
    cudaStreamSynchronize(stream_);
    for (cudaEvent_t event : {forked_, joined_}) cudaEventDestroy(event);
    for (cudaStream_t stream : {stream_, side_stream_}) cudaStreamDestroy(stream);
}

void* CudaBackend::scratch(size_t bytes) {
    if (scratch_.size() < bytes) {
        synchronize();
        scratch_ = Buffer<unsigned char>(bytes + bytes / 2 + 4096);
    }
    return scratch_.span().data;
}

void CudaBackend::exclusiveScan(Span<const uint32_t> in, Span<uint32_t> out) {
    const size_t n = in.count;
    if (n == 0) {
        checkCuda(cudaMemsetAsync(out.data, 0, sizeof(uint32_t), stream_), "adding up");
        return;
    }
    constexpr unsigned kScannedByBlock = kScanThreads * kScannedByThread;
    const auto blocks = static_cast<unsigned>(n / kScannedByBlock + 1);
    if (blocks <= (in.data == out.data ? 1 : kMostScanBlocks))
        return launch(true, scanFew, blocks, kScanThreads, "adding up", WithZero{in.data, n}, out.data);
    const auto padded =
        thrust::make_transform_iterator(thrust::counting_iterator<size_t>(0), WithZero{in.data, n});
    size_t bytes = 0;
    checkCuda(cub::DeviceScan::ExclusiveSum(nullptr, bytes, padded, out.data, n + 1, stream_), "adding up");
    checkCuda(cub::DeviceScan::ExclusiveSum(scratch(bytes), bytes, padded, out.data, n + 1, stream_),
              "adding up");
}

namespace {
struct CountUp {
    uint32_t* ids;
    DEM_FN void operator()(uint32_t i) const { ids[i] = i; }
};
}  // namespace

void CudaBackend::orderByKey(Span<const uint32_t> key, Span<uint32_t> order) {
    const size_t n = key.count;
    if (n == 0) return;
    const int bits = static_cast<int>(std::bit_width(n));
    size_t bytes = 0;
    checkCuda(cub::DeviceRadixSort::SortPairs(nullptr, bytes, key.data, order.data, order.data, order.data, n,
                                              0, bits, stream_),
              "sorting");
    const size_t list = (n * sizeof(uint32_t) + 255) / 256 * 256;
    auto* memory = static_cast<unsigned char*>(scratch(2 * list + bytes));
    auto* ids = reinterpret_cast<uint32_t*>(memory);
    auto* sorted_keys = reinterpret_cast<uint32_t*>(memory + list);
    forEach(n, CountUp{ids}, "sorting");
    checkCuda(cub::DeviceRadixSort::SortPairs(memory + 2 * list, bytes, key.data, sorted_keys, ids,
                                              order.data, n, 0, bits, stream_),
              "sorting");
}

CudaBackend::Reader::Reader(CudaBackend& backend) : stream_(backend.stream_) {
    checkCuda(cudaMallocHost(&pinned_, (kWords + 1) * sizeof(uint32_t)), "allocating pinned memory");
    pinned_[kWords] = 0;
}

CudaBackend::Reader::~Reader() {
    cudaStreamSynchronize(stream_);
    cudaFreeHost(pinned_);
}

namespace {

/// One warp. `cleared`: the words once more, or null. `number`: of this message, written behind it.
__global__ void tellHost(const uint32_t* words, uint32_t count, uint32_t* host, uint32_t* cleared,
                         uint32_t* message, uint32_t number) {
    letNextStart();
    awaitPrevious();
    const uint32_t k = threadIdx.x;
    if (k < count) {
        host[k] = words[k];
        if (cleared != nullptr) cleared[k] = 0;
        __threadfence_system();
    }
    __syncwarp();
    if (k == 0) *static_cast<volatile uint32_t*>(message) = number;
}

}  // namespace

void CudaBackend::Reader::send(CudaBackend& backend, Span<const uint32_t> words, uint32_t* cleared) {
    static_assert(kWords <= 32);
    words_.resize(words.count < kWords ? words.count : kWords);
    backend.launch(true, tellHost, 1, 32, "reading flags", words.data, static_cast<uint32_t>(words_.size()),
                   pinned_, cleared, pinned_ + kWords, ++sent_);
}

void CudaBackend::Reader::start(CudaBackend& backend, Span<const uint32_t> words) {
    send(backend, words, nullptr);
}

void CudaBackend::Reader::take(CudaBackend& backend, Span<uint32_t> words) {
    send(backend, words, words.data);
}

/// Looks at the message's number in its own memory, which costs no call of the driver; now and then asks
/// whether anything has failed.
const std::vector<uint32_t>& CudaBackend::Reader::wait() {
    constexpr uint32_t kLooks = 4096;
    const std::atomic_ref<uint32_t> number(pinned_[kWords]);
    for (uint32_t looks = 1; number.load(std::memory_order_acquire) != sent_; ++looks) {
        if (looks % kLooks != 0) continue;
        const cudaError_t state = cudaStreamQuery(stream_);
        if (state != cudaErrorNotReady) checkCuda(state, "waiting for the GPU");
    }
    words_.assign(pinned_, pinned_ + words_.size());
    return words_;
}

void CudaBackend::readWords(const void* from, size_t bytes, void* to) {
    few_words_->start(*this, {static_cast<const uint32_t*>(from), bytes / sizeof(uint32_t)});
    std::memcpy(to, few_words_->wait().data(), bytes);
}

CudaBackend::Timer::Timer() {
    checkCuda(cudaEventCreate(&start_), "making a timer");
    checkCuda(cudaEventCreate(&stop_), "making a timer");
}

CudaBackend::Timer::~Timer() {
    cudaEventDestroy(start_);
    cudaEventDestroy(stop_);
}

double CudaBackend::Timer::seconds() const {
    checkCuda(cudaEventSynchronize(stop_), "timing");
    float milliseconds = 0;
    checkCuda(cudaEventElapsedTime(&milliseconds, start_, stop_), "timing");
    return 1e-3 * static_cast<double>(milliseconds);
}

}  // namespace demolish
