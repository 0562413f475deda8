// SPDX-License-Identifier: Apache-2.0
// How often a run is looked at.
#pragma once
#include <cstdint>

namespace demolish {

/// Substeps of one stretch: `first`, then a look at the state whose answer travels during the `second` ones.
/// In whole contact steps.
struct Stretch {
    uint32_t first, second;
    constexpr uint32_t length() const { return first + second; }
    /// From what happens right after a look to the end of the stretch whose look sees it.
    constexpr uint32_t blind() const { return second + length(); }
};

/// Something is moved with its bonds: two stretches, for long substeps and for short ones (below
/// kShortSubstep, s), since what may happen unseen is a matter of time.
inline constexpr Stretch kBondedStretch{10, 10}, kShortBondedStretch{20, 20};
inline constexpr double kShortSubstep = 4e-5;
/// Nothing is: contact steps are few, and the answer needs one of them.
inline constexpr Stretch kRigidStretch{30, 10};

/// Substeps that the GPU runs as one graph.
inline constexpr uint32_t kSubstepsTogether = 10;

}  // namespace demolish
