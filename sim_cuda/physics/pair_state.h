// SPDX-License-Identifier: Apache-2.0
// The paper's three kinds of contact as one-way states of a pair (physics A.6), and a fourth: cells of two
// bodies that lie against each other at the start.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/scalar.h"

namespace demolish {

enum class PairState : uint32_t {
    kFacing = 0,   ///< type 1 of spheres that reach each other where the pair began, as L0 says
    kContact = 1,  ///< type 1: never bonded, or the bond record has retired
    kBonded = 2,   ///< type 2: solid bond
    kBroken = 3,   ///< type 3: bond broken, faces may still touch
};

/// A broken pair retires to plain contact beyond this multiple of L0; force-free because contact radii fit
/// inside L0.
inline constexpr double kRetireStretch = 1.08;
/// The same for cells of two bodies. What stands on something may rock by half a cell and still come back to
/// stand as it stood.
inline constexpr double kFacingStretch = 1.5;

/// BONDED -> BROKEN -> CONTACT <- FACING, never back and never 1 -> 2. `breaks`: bondBreaks() of this step;
/// distance, rest length in m.
template <class T>
DEM_FN PairState nextState(PairState state, bool breaks, T distance, T rest_length) {
    if (state == PairState::kBonded) return breaks ? PairState::kBroken : PairState::kBonded;
    if (state == PairState::kBroken)
        return distance > T(kRetireStretch) * rest_length ? PairState::kContact : PairState::kBroken;
    if (state == PairState::kFacing)
        return distance > T(kFacingStretch) * rest_length ? PairState::kContact : PairState::kFacing;
    return PairState::kContact;
}

}  // namespace demolish
