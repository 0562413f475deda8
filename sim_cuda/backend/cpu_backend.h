// SPDX-License-Identifier: Apache-2.0
// The CPU: plain memory and oneTBB. Results never depend on the number of threads.
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/backend/reduction.h"
#include "sim_cuda/backend/span.h"

namespace demolish {

class CpuBackend {
  public:
    static constexpr bool kOnGpu = false;

    /// Owns n elements. Move-only; empty by default. T is trivially copyable.
    template <class T>
    class Buffer {
      public:
        Buffer() = default;
        explicit Buffer(size_t n) : memory_(n > 0 ? new (std::align_val_t{64}) T[n]() : nullptr), count_(n) {}
        Buffer(Buffer&& other) noexcept
            : memory_(std::move(other.memory_)), count_(std::exchange(other.count_, 0)) {}
        Buffer& operator=(Buffer&& other) noexcept {
            memory_ = std::move(other.memory_);
            count_ = std::exchange(other.count_, 0);
            return *this;
        }
        size_t size() const { return count_; }
        Span<T> span() { return {memory_.get(), count_}; }
        Span<const T> span() const { return {memory_.get(), count_}; }
        Span<const T> view() const { return {memory_.get(), count_}; }

      private:
        struct Release {
            void operator()(T* memory) const { ::operator delete[](memory, std::align_val_t{64}); }
        };
        std::unique_ptr<T[], Release> memory_;
        size_t count_ = 0;
    };

    /// n elements, all bits zero.
    template <class T>
    Buffer<T> allocate(size_t n) {
        return Buffer<T>(n);
    }
    template <class T>
    Buffer<T> uploaded(const std::vector<T>& values) {
        Buffer<T> buffer(values.size());
        upload(buffer.span(), values.data(), values.size());
        return buffer;
    }
    template <class T>
    void upload(Span<T> to, const T* from, size_t n) {
        if (n > 0) std::memcpy(to.data, from, n * sizeof(T));
    }
    /// Waits for what was started before.
    template <class T>
    void download(Span<const T> from, T* to) {
        if (from.count > 0) std::memcpy(to, from.data, from.count * sizeof(T));
    }
    template <class T>
    std::vector<std::remove_const_t<T>> downloaded(Span<T> from) {
        return {from.data, from.data + from.count};
    }
    /// Device to device; the sizes are the same.
    template <class T>
    void copy(Span<const T> from, Span<T> to) {
        if (from.count > 0) std::memcpy(to.data, from.data, from.count * sizeof(T));
    }
    template <class T>
    void fill(Span<T> to, const T& value) {
        std::fill(to.data, to.data + to.count, value);
    }

    /// kernel(i) for i in 0..n-1, in any order and at the same time. `name` is for profilers.
    template <class Kernel>
    void forEach(size_t n, const Kernel& kernel, [[maybe_unused]] const char* name) {
        forRanges(n, [&](size_t first, size_t last) { runRange(kernel, first, last); });
    }

    /// kernel(ids[k], step) for all k below count[0] at the same time, for step = 0, 1 ... steps-1, one after
    /// the other, until kernel.isOver(step).
    template <class Kernel>
    void forEachInSteps(Span<const uint32_t> ids, Span<const uint32_t> count, uint32_t steps,
                        const Kernel& kernel, const char* name) {
        for (uint32_t step = 0; step < steps && !kernel.isOver(step); ++step)
            forEach(count[0], StepOf<Kernel>{ids, kernel, step}, name);
    }

    /// range(first, last) over parts of 0..n-1 that do not depend on the number of threads.
    template <class Range>
    void forRanges(size_t n, const Range& range) {
        if (n <= kGrain) {
            if (n > 0) range(size_t{0}, n);
            return;
        }
        const size_t parts = (n + kGrain - 1) / kGrain;
        tbb::parallel_for(size_t{0}, parts,
                          [&](size_t part) { range(part * kGrain, std::min(n, (part + 1) * kGrain)); });
    }

    /// out[k] = in[0] + ... + in[k-1] for k = 0..n; out has n + 1 elements. `in` and `out` may be the same
    /// memory.
    void exclusiveScan(Span<const uint32_t> in, Span<uint32_t> out) {
        uint32_t sum = 0;
        const size_t n = in.count;
        for (size_t i = 0; i < n; ++i) {
            const uint32_t value = in[i];
            out[i] = sum;
            sum += value;
        }
        out[n] = sum;
    }

    /// order = 0 .. n-1 sorted by (key, id); keys are below n.
    void orderByKey(Span<const uint32_t> key, Span<uint32_t> order) {
        const size_t n = key.count;
        std::vector<uint32_t> place(n + 1);
        for (size_t i = 0; i < n; ++i) ++place[key[i] + 1];
        for (size_t k = 0; k < n; ++k) place[k + 1] += place[k];
        for (size_t i = 0; i < n; ++i) order[place[key[i]]++] = static_cast<uint32_t>(i);
    }

    /// Folds map(0) .. map(n-1) in the order of reduction.h; `zero` where n is 0 and as the neutral element.
    template <class T, class Map, class Fold>
    T reduce(size_t n, const T& zero, const Map& map, const Fold& fold, const char* name) {
        if (n == 0) return zero;
        std::vector<T> partial((n + kReductionChunk - 1) / kReductionChunk, zero);
        forEach(
            partial.size(),
            [&](uint32_t chunk) {
                const size_t first = chunk * kReductionChunk;
                partial[chunk] = foldChunk(first, n, zero, map, fold);
            },
            name);
        while (partial.size() > 1) {
            const std::vector<T> before = std::move(partial);
            const auto element = [&](uint32_t i) { return before[i]; };
            partial.assign((before.size() + kReductionChunk - 1) / kReductionChunk, zero);
            for (size_t chunk = 0; chunk < partial.size(); ++chunk)
                partial[chunk] = foldChunk(chunk * kReductionChunk, before.size(), zero, element, fold);
        }
        return partial[0];
    }

    /// The same into result[0].
    template <class T, class Map, class Fold>
    void reduceInto(Span<T> result, size_t n, const T& zero, const Map& map, const Fold& fold,
                    const char* name) {
        result[0] = reduce(n, zero, map, fold, name);
    }

    /// What a GPU does at the same time.
    template <class Main, class Side>
    void sideBySide(const Main& main, const Side& side) {
        main();
        side();
    }

    void synchronize() {}
    static std::nullptr_t stream() { return nullptr; }
    std::string deviceName() const { return "CPU"; }

    /// Words that come back while later work goes on.
    class Reader {
      public:
        explicit Reader(CpuBackend&) {}
        /// Reads them as they are after what was started before.
        void start(CpuBackend&, Span<const uint32_t> words) {
            words_.assign(words.data, words.data + words.count);
        }
        /// The same, and sets them to 0.
        void take(CpuBackend& backend, Span<uint32_t> words) {
            start(backend, words);
            std::fill(words.data, words.data + words.count, 0u);
        }
        /// Waits for them, and not for what was started later.
        const std::vector<uint32_t>& wait() const { return words_; }

      private:
        std::vector<uint32_t> words_;
    };

    /// Stopwatch over work started on this backend.
    class Timer {
      public:
        void start(CpuBackend&) { start_ = std::chrono::steady_clock::now(); }
        void stop(CpuBackend&) { stop_ = std::chrono::steady_clock::now(); }
        /// s; waits for the work between start and stop.
        double seconds() const { return std::chrono::duration<double>(stop_ - start_).count(); }

      private:
        std::chrono::steady_clock::time_point start_, stop_;
    };

  private:
    template <class Kernel>
    struct StepOf {
        Span<const uint32_t> ids;
        const Kernel& kernel;
        uint32_t step;
        void operator()(uint32_t k) const { kernel(ids[k], step); }
    };
    static constexpr size_t kGrain = 256;

    /// Flat, as a GPU's compiler makes a kernel: left to itself this one calls half of the vector arithmetic.
    template <class Kernel>
    [[gnu::flatten]] static void runRange(const Kernel& kernel, size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) kernel(static_cast<uint32_t>(i));
    }

    template <class T, class Map, class Fold>
    static T foldChunk(size_t first, size_t n, const T& zero, const Map& map, const Fold& fold) {
        std::array<T, kReductionChunk> lane;
        for (size_t l = 0; l < kReductionChunk; ++l)
            lane[l] = first + l < n ? map(static_cast<uint32_t>(first + l)) : zero;
        for (size_t step = kReductionChunk / 2; step > 0; step /= 2)
            for (size_t l = 0; l < step; ++l) fold(lane[l], lane[l + step]);
        return lane[0];
    }
};

}  // namespace demolish
