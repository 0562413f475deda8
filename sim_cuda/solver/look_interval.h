// How often a run is looked at.
#pragma once
#include <cstdint>

namespace demolish {

/// Substeps between two moments at which something is decided; even, so that the state ends where it began.
inline constexpr uint32_t kLookInterval = 10;
/// The same while nothing is moved with its bonds.
inline constexpr uint32_t kRigidLookInterval = 40;

}  // namespace demolish
