// SPDX-License-Identifier: Apache-2.0
// Parts that lie in each other become one.
#pragma once
#include "sim_cuda/authoring/repair/winding_samples.h"

namespace demolish {

inline constexpr double kMostOverlap = 0.01;  ///< of the volume that may be counted twice

/// Gives the parts that hold the doubled points of `samples` a common new surface (remesh.h), with the
/// hollows that lie in them; the others stay as they are. Returns how many parts went into such surfaces; 0
/// and an unchanged mesh where a new surface would lose walls that are too thin for it. `repair` is closed;
/// its parts are numbered anew.
size_t uniteParts(RepairMesh& repair, const WindingSamples& samples);

}  // namespace demolish
