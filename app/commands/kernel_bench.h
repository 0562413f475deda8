// SPDX-License-Identifier: Apache-2.0
// The substep alone, by size, beside the floors of the machine: `demolish bench --kernel`.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim_cuda/api/substep_bench.h"

namespace demolish {

/// us of one substep of a block of stone, everything included that comes with substeps: looks at the state,
/// contact lists.
struct KernelRow {
    uint32_t particles = 0, bonds = 0;
    double intact_us = 0;      ///< in free fall: bonds only, nothing touches
    double shattering_us = 0;  ///< on the floor, while bonds break
    uint32_t shattering_broken = 0;
    double broken_us = 0;  ///< rubble on the floor, when `broken_broken` bonds (all of them) are broken
    uint32_t broken_broken = 0;
    SubstepFloor floor;
};

/// Sizes that are timed when none is asked for; the CPU takes the small ones only.
std::span<const uint32_t> kernelSizes(bool cuda);

/// Measured now. Throws DeviceError, and NumericalError when the block blows up.
KernelRow timeKernel(bool cuda, uint32_t particles);

/// Where the rows were measured.
struct KernelPlace {
    std::string device, driver, machine, version;
    unsigned threads = 0;
};

std::string kernelTable(std::span<const KernelRow> rows, const KernelPlace& place);
std::string kernelJson(std::span<const KernelRow> rows, const KernelPlace& place);
std::string kernelCsv(std::span<const KernelRow> rows, const KernelPlace& place);

}  // namespace demolish
