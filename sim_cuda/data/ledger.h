// SPDX-License-Identifier: Apache-2.0
// What a particle has dissipated since the ledger was cleared, J, in one load; and of one that is held, the
// work of what holds it.
#pragma once
#include "sim_cuda/data/vec4.h"

namespace demolish {

template <class Real>
DEM_FN Real& bookedDamping(Vec4<Real>& ledger) {
    return ledger.x;
}
template <class Real>
DEM_FN Real& bookedFriction(Vec4<Real>& ledger) {
    return ledger.y;
}
template <class Real>
DEM_FN Real& bookedFracture(Vec4<Real>& ledger) {
    return ledger.z;
}

template <class Real>
DEM_FN Real& bookedWork(Vec4<Real>& ledger) {
    return ledger.w;
}

}  // namespace demolish
