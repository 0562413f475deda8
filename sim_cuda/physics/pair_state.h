// SPDX-License-Identifier: Apache-2.0
// The paper's three kinds of contact as one-way states of a pair (physics A.6), and its NORMAL/DISCRETE
// stretch rule.
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

/// Delta r of the paper's clustering rule, m: sigma_c A/k_N, the stretch at which tension alone breaks the
/// bond.
template <class T>
DEM_FN T stretchLimit(T strength, T area, T normal_stiffness) {
    return strength * area / normal_stiffness;
}
/// NORMAL while r <= r0 + Delta r, DISCRETE after; compression never breaks. Lengths in m.
template <class T>
DEM_FN bool isDiscrete(T distance, T rest_length, T limit) {
    return distance > rest_length + limit;
}
/// Share of the force left in the DISCRETE state that fades linearly to 0 at r_f > r0 + Delta r; 1 while
/// NORMAL. The caller keeps the smallest value seen, so that it is irreversible.
template <class T>
DEM_FN T discreteShare(T distance, T rest_length, T limit, T fade_end) {
    return clampTo((fade_end - distance) / (fade_end - rest_length - limit), T(0), T(1));
}

}  // namespace demolish
