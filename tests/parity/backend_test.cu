// SPDX-License-Identifier: Apache-2.0
// What the CUDA backend does by itself: prefix sums, work side by side.
#include <gtest/gtest.h>

#include <random>

#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/backend/cuda_backend.cuh"
#include "tests/parity/on_the_gpu.h"

namespace demolish::tests {
namespace {

class CudaBackendTest : public OnTheGpu {};

std::vector<uint32_t> someNumbers(size_t n) {
    std::mt19937 random(static_cast<uint32_t>(n));
    std::vector<uint32_t> numbers(n);
    for (uint32_t& number : numbers) number = random() % 7;
    return numbers;
}

std::vector<uint32_t> sumsOnCpu(const std::vector<uint32_t>& numbers) {
    CpuBackend backend;
    auto in = backend.uploaded(numbers);
    auto out = backend.allocate<uint32_t>(numbers.size() + 1);
    backend.exclusiveScan(in.view(), out.span());
    return backend.downloaded(out.view());
}

TEST_F(CudaBackendTest, PrefixSumsAreThoseOfTheCpuForFewNumbersAndMany) {
    CudaBackend backend;
    for (const size_t n : {0u, 1u, 4'095u, 4'096u, 4'097u, 40'128u, 65'535u, 65'536u, 300'000u}) {
        const std::vector<uint32_t> numbers = someNumbers(n), expected = sumsOnCpu(numbers);
        auto in = backend.uploaded(numbers);
        auto out = backend.allocate<uint32_t>(n + 1);
        backend.exclusiveScan(in.view(), out.span());
        EXPECT_EQ(backend.downloaded(out.view()), expected) << n << " numbers";
        backend.copy(in.view(), out.span().part(0, n));
        backend.exclusiveScan(out.view().part(0, n), out.span());
        EXPECT_EQ(backend.downloaded(out.view()), expected) << n << " numbers in their own place";
    }
}

struct Grow {
    Span<const uint64_t> from;
    Span<uint64_t> to;
    uint64_t factor;
    DEM_FN void operator()(uint32_t i) const { to[i] = from[i] * factor + 1; }
};

/// Chains of kernels, each of which reads what the one before has written: one before, two side by side, one
/// after.
TEST_F(CudaBackendTest, WorkSideBySideComesAfterWhatWasStartedBeforeAndBeforeWhatIsStartedLater) {
    constexpr uint32_t kNumbers = 100'000, kLong = 40, kShort = 3;
    CudaBackend backend;
    auto before = backend.allocate<uint64_t>(kNumbers), main = backend.allocate<uint64_t>(kNumbers),
         side = backend.allocate<uint64_t>(kNumbers);
    const auto grow = [&](auto& from, auto& to, uint64_t factor) {
        backend.forEach(kNumbers, Grow{from.view(), to.span(), factor}, "grow");
    };
    uint64_t expected_before = 0, expected_main = 0, expected_side = 0;
    for (int round = 0; round < 20; ++round) {
        const bool side_is_longer = round % 2 != 0;
        const uint32_t on_main = side_is_longer ? kShort : kLong, on_side = side_is_longer ? kLong : kShort;
        grow(before, before, 3);
        expected_main = expected_side = expected_before = 3 * expected_before + 1;
        backend.sideBySide(
            [&] {
                grow(before, main, 1);
                for (uint32_t k = 0; k < on_main; ++k) grow(main, main, 5);
            },
            [&] {
                grow(before, side, 1);
                for (uint32_t k = 0; k < on_side; ++k) grow(side, side, 7);
            });
        ++expected_main;
        ++expected_side;
        for (uint32_t k = 0; k < on_main; ++k) expected_main = 5 * expected_main + 1;
        for (uint32_t k = 0; k < on_side; ++k) expected_side = 7 * expected_side + 1;
        grow(main, before, side_is_longer ? 2 : 1);
        expected_before = (side_is_longer ? 2 : 1) * expected_main + 1;
        grow(side, main, 1);
        ASSERT_EQ(backend.downloaded(before.view()), std::vector<uint64_t>(kNumbers, expected_before));
        ASSERT_EQ(backend.downloaded(main.view()), std::vector<uint64_t>(kNumbers, expected_side + 1));
    }
}

/// Each step reads what the one before has written elsewhere in the list, and the last one moves nothing.
struct MixAround {
    Span<uint32_t> even, odd, moved;
    uint32_t listed, last;
    DEM_FN bool isOver(uint32_t step) const { return step > 0 && moved[step - 1] == 0; }
    DEM_FN void operator()(uint32_t id, uint32_t step) const {
        const Span<uint32_t>&from = step % 2 == 0 ? even : odd, &to = step % 2 == 0 ? odd : even;
        const uint32_t k = id / 3, far = (k * 7919u + step) % listed;
        to[id] = step < last ? from[id] * 5u + from[3 * far] : from[id];
        if (step < last) raise(moved[step]);
    }
};

template <class Backend>
std::vector<uint32_t> mixedAround(uint32_t listed, uint32_t last, uint32_t steps) {
    Backend backend;
    std::vector<uint32_t> ids(listed + 10), numbers = someNumbers(3 * size_t{listed} + 3);
    for (uint32_t k = 0; k < ids.size(); ++k) ids[k] = 3 * k;
    const auto list = backend.uploaded(ids), count = backend.uploaded(std::vector<uint32_t>{listed});
    auto even = backend.uploaded(numbers), odd = backend.uploaded(numbers);
    auto moved = backend.template allocate<uint32_t>(steps);
    backend.forEachInSteps(list.view(), count.view(), steps,
                           MixAround{even.span(), odd.span(), moved.span(), listed, last}, "mix around");
    std::vector<uint32_t> all = backend.downloaded(even.view());
    for (const auto& more : {backend.downloaded(odd.view()), backend.downloaded(moved.view())})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

TEST_F(CudaBackendTest, StepsOfAListAreThoseOfTheCpuForFewElementsAndMany) {
    for (const uint32_t listed : {1u, 500u, 70'000u, 300'000u})
        for (const uint32_t last : {0u, 11u, 24u})
            EXPECT_EQ(mixedAround<CudaBackend>(listed, last, 24), mixedAround<CpuBackend>(listed, last, 24))
                << listed << " listed, over after " << last;
}

}  // namespace
}  // namespace demolish::tests
