// SPDX-License-Identifier: Apache-2.0
// Launches of kernels that may start while the one before still runs (programmatic dependent launch): such a
// kernel calls letNextStart() and, before it reads or writes what others write, awaitPrevious(). And the list
// of such launches, for those that are to be made later.
#pragma once
#include <cuda_runtime.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "sim_cuda/backend/cuda_error.h"

namespace demolish {

/// The kernel after this one may start. Nothing on GPUs that know of no such thing.
__device__ __forceinline__ void letNextStart() {
#if __CUDA_ARCH__ >= 900
    cudaTriggerProgrammaticLaunchCompletion();
#endif
}
/// Until all that was started before is done and can be seen.
__device__ __forceinline__ void awaitPrevious() {
#if __CUDA_ARCH__ >= 900
    cudaGridDependencySynchronize();
#endif
}

/// Whether the code that runs was compiled for a GPU on which kernels can wait for the one before.
inline bool awaitsPrevious(const void* kernel) {
    cudaFuncAttributes attributes{};
    return cudaFuncGetAttributes(&attributes, kernel) == cudaSuccess && attributes.ptxVersion >= 90;
}

/// One launch without its arguments. `follows`: whatever is launched before it on the stream, nothing that
/// this one reads before awaitPrevious() is written by anything that may still run.
struct LaunchShape {
    const void* kernel = nullptr;
    dim3 blocks;
    uint32_t threads = 0;
    bool follows = false;

    /// Whether a node of a graph can become this one.
    bool isLike(const LaunchShape& other) const {
        return kernel == other.kernel && threads == other.threads && follows == other.follows;
    }
};

/// `arguments`: a pointer to each. `name`: what for, in messages. Throws on failure.
inline void launchKernel(cudaStream_t stream, const LaunchShape& shape, void** arguments, const char* name) {
    cudaLaunchAttribute early{};
    early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    early.val.programmaticStreamSerializationAllowed = 1;
    cudaLaunchConfig_t config{};
    config.gridDim = shape.blocks;
    config.blockDim = shape.threads;
    config.stream = stream;
    config.attrs = &early;
    config.numAttrs = shape.follows ? 1 : 0;
    checkCuda(cudaLaunchKernelExC(&config, shape.kernel, arguments), name);
}

/// Launches with copies of their arguments.
class LaunchList {
  public:
    template <class... Parameters>
    void add(const LaunchShape& shape, const Parameters&... parameters) {
        static_assert((std::is_trivially_copyable_v<Parameters> && ...));
        shapes_.push_back(shape);
        (keep(&parameters, sizeof(Parameters)), ...);
        ends_.push_back(places_.size());
    }
    void clear() {
        shapes_.clear();
        places_.clear();
        ends_.clear();
        memory_.clear();
    }
    /// The first one starts after whatever comes before the list: in a graph no launch follows another one's.
    void startAlone() {
        if (!shapes_.empty()) shapes_.front().follows = false;
    }
    size_t size() const { return shapes_.size(); }
    const LaunchShape& shape(size_t k) const { return shapes_[k]; }
    /// A pointer to each argument of launch k; valid until the list changes.
    std::vector<void*> arguments(size_t k) {
        std::vector<void*> pointers;
        for (size_t a = k == 0 ? 0 : ends_[k - 1]; a < ends_[k]; ++a)
            pointers.push_back(memory_.data() + places_[a]);
        return pointers;
    }

  private:
    void keep(const void* value, size_t bytes) {
        constexpr size_t kAlignment = alignof(std::max_align_t);
        const size_t place = (memory_.size() + kAlignment - 1) / kAlignment * kAlignment;
        memory_.resize(place + bytes);
        std::memcpy(memory_.data() + place, value, bytes);
        places_.push_back(place);
    }
    std::vector<LaunchShape> shapes_;
    std::vector<size_t> places_;  ///< of each argument in memory_
    std::vector<size_t> ends_;    ///< of each launch's arguments
    std::vector<std::byte> memory_;
};

/// Of a kernel: its parameters in memory, in the types that it declares.
template <class... Parameters>
class KernelOf {
  public:
    KernelOf(void (*kernel)(Parameters...), dim3 blocks, uint32_t threads, bool follows)
        : shape_{reinterpret_cast<const void*>(kernel), blocks, threads, follows && awaits(kernel)} {}

    void launch(cudaStream_t stream, const char* name, std::remove_cv_t<Parameters>... parameters) const {
        void* arguments[] = {&parameters...};
        launchKernel(stream, shape_, arguments, name);
    }
    void addTo(LaunchList& list, const std::remove_cv_t<Parameters>&... parameters) const {
        list.add(shape_, parameters...);
    }

  private:
    /// The kernels of a build are compiled alike.
    static bool awaits(void (*kernel)(Parameters...)) {
        static const bool all_await = awaitsPrevious(reinterpret_cast<const void*>(kernel));
        return all_await;
    }
    LaunchShape shape_;
};

}  // namespace demolish
