// SPDX-License-Identifier: Apache-2.0
// The paper's three kinds of contact as one-way states of a pair (physics A.6).
#pragma once
#include <cstdint>

#include "sim_cuda/physics/scalar.h"

namespace demolish {

enum class PairState : uint32_t {
    kContact = 1,  ///< type 1: never bonded, or the bond record has retired
    kBonded = 2,   ///< type 2: solid bond
    kBroken = 3,   ///< type 3: bond broken, faces may still touch
};

/// A broken pair retires to plain contact beyond this multiple of L0; force-free because contact radii fit
/// inside L0.
inline constexpr double kRetireStretch = 1.08;

/// BONDED -> BROKEN -> CONTACT, never back and never 1 -> 2. `breaks`: bondBreaks() of this step; distance,
/// rest length in m.
template <class T>
DEM_FN PairState nextState(PairState state, bool breaks, T distance, T rest_length) {
    if (state == PairState::kBonded) return breaks ? PairState::kBroken : PairState::kBonded;
    if (state == PairState::kBroken)
        return distance > T(kRetireStretch) * rest_length ? PairState::kContact : PairState::kBroken;
    return PairState::kContact;
}

}  // namespace demolish
