// SPDX-License-Identifier: Apache-2.0
// Type 3, a broken bond whose faces still touch: (14), (15) as corrected in physics A.5. The normal is the
// line of centres and the rest distance stays L0, so that the force does not jump at fracture and spinning in
// place makes no overlap. Constants and friction: brokenTouchLaw() of touch_law.h, with k_T; M_N = M_T = 0.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// delta_b = L0 - |x_j - x_i|, m; > 0 while the faces press on each other.
template <class T>
DEM_FN T brokenOverlap(T rest_length, T distance) {
    return rest_length - distance;
}
/// (14') compressive part k_N max(delta_b, 0), N.
template <class T>
DEM_FN T brokenRepulsion(T normal_stiffness, T overlap) {
    return normal_stiffness * maxOf(overlap, T(0));
}
/// Energy that leaves with the bond, J: its elastic energy less what the compressed faces keep (A.6). Booked
/// as fracture.
template <class T>
DEM_FN T fractureEnergy(T elastic_energy, T normal_stiffness, T overlap) {
    const T kept = maxOf(overlap, T(0));
    return elastic_energy - T(0.5) * normal_stiffness * kept * kept;
}

}  // namespace demolish
