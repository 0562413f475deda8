// SPDX-License-Identifier: Apache-2.0
// How stiff a body becomes when it is softened to a step: what the number of substeps is chosen by.
#pragma once
#include <cstdint>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/api/params.h"

namespace demolish {

/// Effective wave speed c_eff (m/s) that a softened body gets from so many substeps per 1/60 s (> 0) at this
/// step safety; proportional to their number. From the body's own highest frequency, found as when a solver
/// is made (models.md E.1): kappa = dt_crit c_eff / h is 0.68 within 5 % for compact bodies of any size, 0.54
/// to 0.70 for a wall of one or two cells. 0 without bonds.
double softenedWaveSpeed(const BreakableBody& body, const Material& material, uint32_t substeps,
                         double step_safety);

}  // namespace demolish
