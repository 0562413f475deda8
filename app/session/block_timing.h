// SPDX-License-Identifier: Apache-2.0
// How long a substep takes on this machine, measured on blocks of stone.
#pragma once
#include <cstdint>
#include <memory>

#include "sim_cuda/api/substep_bench.h"

namespace demolish {

/// kIntact: in free fall, bonds only. kShattering: on the floor, while bonds break. kBroken: rubble.
enum class BlockState { kIntact, kShattering, kBroken };

struct BlockTime {
    double microseconds = 0;         ///< a substep
    uint32_t bonds = 0, broken = 0;  ///< at the end
};

/// Measured now. Throws DeviceError, and NumericalError when the block blows up.
BlockTime timeBlock(bool cuda, const std::shared_ptr<const BreakableBody>& body, BlockState state);

}  // namespace demolish
