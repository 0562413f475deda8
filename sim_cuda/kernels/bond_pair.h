// SPDX-License-Identifier: Apache-2.0
// The constants of a solid bond as its slot and its body's law hold them.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/step_params.h"

namespace demolish {

/// m, a_b.
template <class Real>
DEM_FN Real gradedRadius(uint32_t grade, const BodyLaw<Real>& law) {
    return law.radius_unit * static_cast<Real>(gradeRadius(grade));
}
/// Pa, s_b sigma_c.
template <class Real>
DEM_FN Real gradedStrength(uint32_t grade, const BodyLaw<Real>& law) {
    return law.strength_unit * static_cast<Real>(gradeStrength(grade));
}

/// `rest`: as BondRowsIn has it.
template <class Real>
DEM_FN BondConstants<Real> bondConstants(const Vec4<Real>& rest, uint32_t grade, const BodyLaw<Real>& law) {
    const Real radius = gradedRadius(grade, law);
    return {xyz(rest), roundBond(normalStiffnessOf(rest), law.shear_ratio, radius), radius,
            gradedStrength(grade, law), law.beta_r};
}

}  // namespace demolish
