// SPDX-License-Identifier: Apache-2.0
// Whole-number atomics with one spelling on both devices. There are none for floats: their sums would depend
// on order.
#pragma once
#include <cstdint>
#if !defined(__CUDA_ARCH__)
#include <atomic>
#include <functional>
#endif

#include "sim_cuda/physics/function.h"

namespace demolish {

#if !defined(__CUDA_ARCH__)
/// Puts `value` where the word stands behind it, by `before`; returns the word before. Host only.
template <class Before>
inline uint32_t replaceWhere(uint32_t* target, uint32_t value, Before before) {
    std::atomic_ref<uint32_t> reference(*target);
    uint32_t former = reference.load(std::memory_order_relaxed);
    while (before(value, former) &&
           !reference.compare_exchange_weak(former, value, std::memory_order_relaxed)) {
    }
    return former;
}
#endif

/// A word that other threads may be changing.
DEM_FN uint32_t atomicLoadU32(const uint32_t* source) {
#if defined(__CUDA_ARCH__)
    return *const_cast<const volatile uint32_t*>(source);
#else
    return std::atomic_ref<uint32_t>(*const_cast<uint32_t*>(source)).load(std::memory_order_relaxed);
#endif
}

/// Returns the value before.
DEM_FN uint32_t atomicAddU32(uint32_t* target, uint32_t value) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(target, value);
#else
    return std::atomic_ref<uint32_t>(*target).fetch_add(value, std::memory_order_relaxed);
#endif
}

/// Wraps round: sums of hashes. Returns the value before.
DEM_FN uint64_t atomicAddU64(uint64_t* target, uint64_t value) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(reinterpret_cast<unsigned long long*>(target), static_cast<unsigned long long>(value));
#else
    return std::atomic_ref<uint64_t>(*target).fetch_add(value, std::memory_order_relaxed);
#endif
}

DEM_FN void atomicOrU32(uint32_t* target, uint32_t bits) {
#if defined(__CUDA_ARCH__)
    atomicOr(target, bits);
#else
    std::atomic_ref<uint32_t>(*target).fetch_or(bits, std::memory_order_relaxed);
#endif
}

/// Returns the value before.
DEM_FN uint32_t atomicMinU32(uint32_t* target, uint32_t value) {
#if defined(__CUDA_ARCH__)
    return atomicMin(target, value);
#else
    return replaceWhere(target, value, std::less<>());
#endif
}

/// Returns the value before. Positive floats keep their order when compared as their bits.
DEM_FN uint32_t atomicMaxU32(uint32_t* target, uint32_t value) {
#if defined(__CUDA_ARCH__)
    return atomicMax(target, value);
#else
    return replaceWhere(target, value, std::greater<>());
#endif
}

/// From 0 to 1, by many threads, most of which find it raised.
DEM_FN void raise(uint32_t& word) {
    if (atomicLoadU32(&word) == 0) atomicOrU32(&word, 1u);
}

}  // namespace demolish
