// SPDX-License-Identifier: Apache-2.0
// Blocks in three states and the floors of their bodies.
#include "app/commands/kernel_bench.h"

#include <array>

#include "app/session/block_timing.h"

namespace demolish {
namespace {

constexpr std::array<uint32_t, 6> kGpuSizes{2'000, 10'000, 50'000, 100'000, 200'000, 1'000'000};
constexpr size_t kCpuSizes = 2;  // of them

}  // namespace

std::span<const uint32_t> kernelSizes(bool cuda) {
    return std::span(kGpuSizes).first(cuda ? kGpuSizes.size() : kCpuSizes);
}

KernelRow timeKernel(bool cuda, uint32_t particles) {
    const auto body = stoneBlock(particles);
    const BlockTime intact = timeBlock(cuda, body, BlockState::kIntact);
    const BlockTime shattering = timeBlock(cuda, body, BlockState::kShattering);
    const BlockTime broken = timeBlock(cuda, body, BlockState::kBroken);
    KernelRow row;
    row.particles = static_cast<uint32_t>(body->particles.size());
    row.bonds = intact.bonds;
    row.intact_us = intact.microseconds;
    row.shattering_us = shattering.microseconds;
    row.shattering_broken = shattering.broken;
    row.broken_us = broken.microseconds;
    row.broken_broken = broken.broken;
    row.floor = cuda ? cudaSubstepFloor(*body) : cpuSubstepFloor(*body);
    return row;
}

}  // namespace demolish
