// SPDX-License-Identifier: Apache-2.0
// The constants of a contact step.
#pragma once
#include <algorithm>

#include "sim_cuda/kernels/step_params.h"

namespace demolish {

/// What a contact step of `stride` substeps after one of `previous` changes in the constants of a substep.
/// What touches may push for longer than the step lasts, and its laws have to bear that.
template <class Real>
StepParams<Real> rigidParams(StepParams<Real> params, uint32_t previous, uint32_t stride) {
    const double length = std::max<double>(stride, pushedSubsteps(previous, stride)),
                 dt = length * static_cast<double>(params.dt);
    params.own_cap = params.stiffness_cap;
    params.drift = static_cast<Real>(previous) * params.dt;
    params.dt = static_cast<Real>(dt);
    params.stiffness_cap = params.face_cap = static_cast<Real>(kContactStiffnessShare / (dt * dt));
    params.softening = params.leaves_out = 1;
    return params;
}

}  // namespace demolish
