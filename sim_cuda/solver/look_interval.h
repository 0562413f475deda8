// SPDX-License-Identifier: Apache-2.0
// How often a run is looked at.
#pragma once
#include <cstdint>

namespace demolish {

/// Substeps of one stretch: `first`, then a look at the state whose answer travels during the `second` ones.
/// Even, so that the state ends where it began.
struct Stretch {
    uint32_t first, second;
    constexpr uint32_t length() const { return first + second; }
};

/// Something is moved with its bonds: two stretches, for long substeps and for short ones (below
/// kShortSubstep, s), since what may happen unseen is a matter of time.
inline constexpr Stretch kBondedStretch{10, 10}, kShortBondedStretch{20, 20};
inline constexpr double kShortSubstep = 4e-5;
/// Nothing is: contact steps are few, and the answer needs one of them.
inline constexpr Stretch kRigidStretch{30, 10};

/// No longer than so many substeps, but one step of `step` substeps at least, and whole ones: a contact step
/// that is shorter than the one before it would not keep its energy.
constexpr Stretch cutShort(Stretch usual, uint32_t most, uint32_t step) {
    if (most >= usual.length()) return usual;
    const uint32_t steps = most / step > 1 ? most / step : 1, second = steps / 2;
    return {(steps - second) * step, second * step};
}

/// Substeps that the GPU runs as one graph.
inline constexpr uint32_t kSubstepsTogether = 10;

}  // namespace demolish
