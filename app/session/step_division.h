// SPDX-License-Identifier: Apache-2.0
// Bodies for which a substep of half the critical step is too long.
#pragma once
#include <cstdint>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/api/params.h"

namespace demolish {

/// Steps into which each of the substeps asked for (per 1/60 s) is divided while bonds stay as soft as these
/// make them. 1; or 2 where half the critical step leaves the books open:
/// - in rubber, that stretches by more than a tenth before it breaks, bonds and contacts turn by much in
///   a substep, and cells sink into each other until the dampers of many contacts overshoot together;
/// - a cell of many spacings' length turns so easily that its bonds and the corners that it lands on, each
///   stable by itself, are not stable together.
uint32_t stepDivision(const BreakableBody& body, const Material& material, uint32_t substeps,
                      double step_safety);

}  // namespace demolish
