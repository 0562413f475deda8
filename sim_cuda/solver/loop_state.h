// SPDX-License-Identifier: Apache-2.0
// Where the frame loop stands, as a snapshot keeps it.
#pragma once
#include <cstdint>

#include "sim_cuda/solver/decisions.h"
#include "sim_cuda/solver/list_schedule.h"
#include "sim_cuda/solver/projectiles.h"

namespace demolish {

/// What changes on the host while stepping.
struct LoopState {
    uint64_t substeps = 0;        ///< since the start
    uint64_t quiet = 0;           ///< 1: nothing has moved in the last frame, nor will unless it is shot at
    uint64_t contact_stride = 1;  ///< as Stepper::contactStride(): all has been moved with its bonds
    Projectiles::State projectiles;
    ListSchedule::State lists;
    DecisionState decisions;
};

}  // namespace demolish
