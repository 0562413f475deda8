// SPDX-License-Identifier: Apache-2.0
// The CPU's share: how fast memory can be copied.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <memory>

#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/bench/floor_problem.h"

namespace demolish {
namespace {

constexpr size_t kCopyBytes = size_t{64} << 20;  // well beyond the caches
constexpr size_t kChunk = size_t{1} << 20;
constexpr int kRepeats = 5;

/// bytes/s, read and written together; the median of some copies.
double copyBandwidth() {
    const auto from = std::make_unique<std::byte[]>(kCopyBytes),
               to = std::make_unique<std::byte[]>(kCopyBytes);
    std::array<double, kRepeats> seconds{};
    const auto copyAll = [&] {
        tbb::parallel_for(size_t{0}, kCopyBytes / kChunk, [&](size_t chunk) {
            std::memcpy(to.get() + chunk * kChunk, from.get() + chunk * kChunk, kChunk);
        });
    };
    copyAll();  // the pages come into being
    for (auto& time : seconds) {
        const auto begun = std::chrono::steady_clock::now();
        copyAll();
        time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    }
    std::sort(seconds.begin(), seconds.end());
    return 2 * static_cast<double>(kCopyBytes) / seconds[kRepeats / 2];
}

}  // namespace

SubstepFloor cpuSubstepFloor(const BreakableBody& body) {
    SubstepFloor floor;
    floor.bytes = bytesOfSubstep(body.particles.size(), body.bonds.size());
    floor.copy_bandwidth = copyBandwidth();
    floor.memory_us = 1e6 * floor.bytes / floor.copy_bandwidth;
    return floor;
}

}  // namespace demolish
