// SPDX-License-Identifier: Apache-2.0
// How far the two cells of a broken bond have come apart: what a crack's width on the picture follows.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/particles.h"

namespace demolish {

/// One thread a bond.
template <class Real>
struct MeasureOpenings {
    StateIn<Real> state;
    BondRowsIn<Real> bonds;
    Span<const uint32_t> slot_of_bond, twin;
    Span<float> opening;  ///< m, >= 0: distance of the two seeds over that at rest; 0 while the bond holds

    DEM_FN void operator()(uint32_t b) const {
        const uint32_t slot = slot_of_bond[b];
        opening[b] = isBonded(bonds.link[slot]) ? 0.0f : openingOf(slot);
    }

  private:
    DEM_FN float openingOf(uint32_t slot) const {
        const uint32_t i = linkedParticle(bonds.link[twin[slot]]), j = linkedParticle(bonds.link[slot]);
        const Vec3<Real> high = xyz(state.position[j]) - xyz(state.position[i]);
        const Vec3<Real> now = high + (lowOf(j) - lowOf(i));
        const Real over = length(now) - length(xyz(bonds.rest[slot]));
        return over > 0 ? static_cast<float>(over) : 0.0f;
    }
    DEM_FN Vec3<Real> lowOf(uint32_t i) const {
        return lowPart(state.position[i], state.velocity[i], state.spin[i]);
    }
};

}  // namespace demolish
