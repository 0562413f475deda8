// SPDX-License-Identifier: Apache-2.0
// What the particle view is coloured by, 0..1.
#pragma once
#include "sim_cuda/kernels/own_particle.h"

namespace demolish {

/// Every `of`-th slot of a row from slot `number` on.
struct RowPart {
    uint32_t number = 0, of = 1;
};

/// (E2) over strength of a particle's worst solid bond, 0..1; what a stress colour shows. Of the bonds to
/// particles from `least` on: it is the same at both ends.
template <class Real>
DEM_FN Real worstStressRatio(const SubstepArrays<Real>& arrays, const OwnParticle<Real>& own,
                             uint32_t least = 0, RowPart part = {}) {
    Real worst = Real(0);
    for (uint32_t s = arrays.bond_row[own.id] + part.number; s < arrays.bond_row[own.id + 1]; s += part.of) {
        const BondLink link = arrays.link[s];
        if (!isBonded(link) || linkedParticle(link) < least) continue;
        const BondConstants<Real> bond =
            bondConstants(arrays.rest[s], link.grade, arrays.body_laws[own.owner]);
        const PairMotion<Real> pair = pairMotion(own.state, loadState(arrays.in, linkedParticle(link)));
        const BondEffect<Real> effect = bondEffect(bond, pair);
        worst = maxOf(worst, effect.severity / effect.limit);
    }
    return worst;
}

template <class Real>
DEM_FN Real stressValue(const SubstepArrays<Real>& arrays, const OwnParticle<Real>& own) {
    return minOf(worstStressRatio(arrays, own), Real(1));
}

/// `scale`: 1/(m/s), 1 over the speed at which it is 1.
template <class Real>
DEM_FN Real speedValue(const OwnParticle<Real>& own, Real scale) {
    return minOf(scale * length(xyz(own.state.velocity)), Real(1));
}

/// Share of its bonds that are broken.
template <class Real>
DEM_FN Real damageValue(const SubstepArrays<Real>& arrays, uint32_t i) {
    const uint32_t first = arrays.bond_row[i], last = arrays.bond_row[i + 1];
    uint32_t bonds = 0, broken = 0;
    for (uint32_t s = first; s < last; ++s) {
        bonds += arrays.link[s].grade != 0 ? 1u : 0u;
        broken += isBroken(arrays.link[s]) ? 1u : 0u;
    }
    return bonds == 0 ? Real(0) : static_cast<Real>(broken) / static_cast<Real>(bonds);
}

}  // namespace demolish
