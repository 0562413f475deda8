// SPDX-License-Identifier: Apache-2.0
// A view of memory on either device, and nothing more: kernels take their inputs and outputs as these.
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "sim_cuda/physics/function.h"

namespace demolish {

/// Not owning. `Span<T>` converts to `Span<const T>`.
template <class T>
struct Span {
    T* data = nullptr;
    size_t count = 0;

    Span() = default;
    DEM_FN Span(T* first, size_t n) : data(first), count(n) {}
    template <class U, class = std::enable_if_t<std::is_same_v<const U, T>>>
    DEM_FN Span(const Span<U>& other) : data(other.data), count(other.count) {}

    DEM_FN T& operator[](size_t i) const { return data[i]; }
    DEM_FN size_t size() const { return count; }
    DEM_FN bool empty() const { return count == 0; }
    DEM_FN Span part(size_t first, size_t n) const { return Span(data + first, n); }
};

}  // namespace demolish
