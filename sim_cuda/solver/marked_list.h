// SPDX-License-Identifier: Apache-2.0
// Elements that are marked, in ascending order, and kernels over them alone. On a GPU the host never learns
// how many there are.
#pragma once
#include <algorithm>
#include <cstdint>

#include "sim_cuda/backend/span.h"
#include "sim_cuda/physics/function.h"

namespace demolish {

struct ListMarked {
    Span<const uint32_t> place;  ///< exclusive scan of the marks
    Span<uint32_t> ids;
    DEM_FN void operator()(uint32_t i) const {
        if (place[i + 1] != place[i]) ids[place[i]] = i;
    }
};

/// Threads take every so many elements.
template <class Kernel>
struct OverList {
    Span<const uint32_t> ids, count;  ///< count: one word
    uint32_t threads;
    Kernel kernel;
    DEM_FN void operator()(uint32_t thread) const {
        for (uint32_t k = thread; k < count[0]; k += threads) kernel(ids[k]);
    }
};

template <class Backend>
class MarkedList {
  public:
    /// Keeps a reference to the backend. Nothing is listed.
    MarkedList(Backend& backend, size_t elements)
        : backend_(backend),
          marks_(backend.template allocate<uint32_t>(elements)),
          place_(backend.template allocate<uint32_t>(elements + 1)),
          ids_(backend.template allocate<uint32_t>(elements)) {}

    /// Per element: 1 to list it, 0 not to.
    Span<uint32_t> marks() { return marks_.span(); }
    Span<const uint32_t> marks() const { return marks_.view(); }

    /// Lists what is marked now.
    void gather() {
        backend_.exclusiveScan(marks_.view(), place_.span());
        backend_.forEach(marks_.size(), ListMarked{place_.view(), ids_.span()}, "list marked");
    }

    /// kernel(id) for all that is listed, in any order and at the same time.
    template <class Kernel>
    void forEach(const Kernel& kernel, const char* name) {
        const size_t n = marks_.size();
        const Span<const uint32_t> count = place_.view().part(n, 1);
        uint32_t threads = static_cast<uint32_t>(std::min<size_t>(n, kMostThreads));
        if constexpr (!Backend::kOnGpu) threads = count[0];
        backend_.forEach(threads, OverList<Kernel>{ids_.view(), count, threads, kernel}, name);
    }

    /// kernel(id, step) for all that is listed at the same time, step after step, until kernel.isOver(step).
    template <class Kernel>
    void forEachInSteps(uint32_t steps, const Kernel& kernel, const char* name) {
        const Span<const uint32_t> count = place_.view().part(marks_.size(), 1);
        backend_.forEachInSteps(ids_.view(), count, steps, kernel, name);
    }

  private:
    /// As many as a large GPU runs at once, or nearly so.
    static constexpr size_t kMostThreads = 1u << 17;

    template <class T>
    using Buffer = typename Backend::template Buffer<T>;
    Backend& backend_;
    Buffer<uint32_t> marks_, place_, ids_;
};

}  // namespace demolish
