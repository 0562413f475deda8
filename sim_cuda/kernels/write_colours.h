// SPDX-License-Identifier: Apache-2.0
// All colours of the particle view at once, a byte each: what a recording keeps.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/kernels/particle_value.h"

namespace demolish {

/// One thread a particle of the bodies, as far as the streams reach.
template <class Real>
struct WriteColours {
    SubstepArrays<Real> arrays;  ///< only read
    Span<uint8_t> damage, stress, speed;
    Real speed_scale{};  ///< 1/(m/s): 1 at this speed

    DEM_FN void operator()(uint32_t i) const {
        const OwnParticle<Real> own = loadOwn(arrays, i);
        damage[i] = asByte(damageValue(arrays, i));
        stress[i] = asByte(stressValue(arrays, own));
        speed[i] = asByte(speedValue(own, speed_scale));
    }
    /// 0..1 as 0..255, to the nearest.
    static DEM_FN uint8_t asByte(Real value) {
        return static_cast<uint8_t>(madd(Real(255), value, Real(0.5)));
    }
};

}  // namespace demolish
