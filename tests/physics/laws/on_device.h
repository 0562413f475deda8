// SPDX-License-Identifier: Apache-2.0
// Where the laws of these tests are evaluated: plain C++ calls them here; compiled by nvcc the same bodies
// call them on the GPU, one thread for one call, one thread an element for a batch.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "sim_cuda/physics/function.h"

#if defined(__CUDACC__)
#include <cuda_runtime.h>
#endif

namespace demolish::laws {

#if defined(__CUDACC__)

/// Throws std::runtime_error: a test that cannot reach its device has failed.
inline void check(cudaError_t error) {
    if (error != cudaSuccess) throw std::runtime_error(cudaGetErrorString(error));
}

/// Memory that host and device see at the same address.
template <class T>
struct Allocator {
    using value_type = T;
    Allocator() = default;
    template <class U>
    Allocator(const Allocator<U>&) {}
    T* allocate(size_t n) {
        void* memory = nullptr;
        check(cudaMallocHost(&memory, n * sizeof(T)));
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, size_t) { cudaFreeHost(memory); }
    template <class U>
    bool operator==(const Allocator<U>&) const {
        return true;
    }
};
template <class T>
using Shared = std::vector<T, Allocator<T>>;

template <class Law>
__global__ void eachKernel(size_t n, const Law law) {
    const size_t i = size_t{blockIdx.x} * blockDim.x + threadIdx.x;
    if (i < n) law(i);
}
/// law(i) for i = 0 .. n-1, in any order; it may read and write shared memory alone.
template <class Law>
void forEach(size_t n, const Law& law) {
    constexpr unsigned kThreads = 128;
    if (n == 0) return;
    eachKernel<<<static_cast<unsigned>((n + kThreads - 1) / kThreads), kThreads, 0, cudaStreamPerThread>>>(
        n, law);
    check(cudaGetLastError());
    check(cudaDeviceSynchronize());
}

template <class T>
struct Boxed {
    T value;
};
template <class Result, class Law, class... Arguments>
__global__ void oneKernel(Boxed<Result>* result, const Law law, const Arguments... arguments) {
    result->value = law(arguments...);
}
/// law(arguments...).
template <class Law, class... Arguments>
auto evaluate(const Law& law, const Arguments&... arguments) {
    using Result = std::remove_cvref_t<decltype(law(arguments...))>;
    static Shared<Boxed<Result>> result(1);
    oneKernel<<<1, 1, 0, cudaStreamPerThread>>>(result.data(), law, arguments...);
    check(cudaGetLastError());
    check(cudaDeviceSynchronize());
    return result[0].value;
}

#else

template <class T>
using Shared = std::vector<T>;

template <class Law>
void forEach(size_t n, const Law& law) {
    for (size_t i = 0; i < n; ++i) law(i);
}
template <class Law, class... Arguments>
auto evaluate(const Law& law, const Arguments&... arguments) {
    return law(arguments...);
}

#endif

}  // namespace demolish::laws

/// laws::name(...) is space::name(...) evaluated there.
#define DEMOLISH_LAW_OF(space, name)                          \
    struct Law_##name {                                       \
        template <class... Arguments>                         \
        DEM_FN auto operator()(const Arguments&... a) const { \
            return space::name(a...);                         \
        }                                                     \
    };                                                        \
    template <class... Arguments>                             \
    auto name(const Arguments&... arguments) {                \
        return evaluate(Law_##name{}, arguments...);          \
    }
#define DEMOLISH_LAW(name) DEMOLISH_LAW_OF(demolish, name)
